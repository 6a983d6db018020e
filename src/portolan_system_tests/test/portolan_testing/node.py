# SPDX-License-Identifier: BSD-3-Clause
"""A node of ours in a process of its own, seen from outside."""
import re
import subprocess
import tempfile

import roslib.packages
import rospy
from diagnostic_msgs.msg import DiagnosticArray
from nav_msgs.srv import GetMap
from std_srvs.srv import Trigger

from portolan_testing.grid import Grid
from portolan_testing.room import RESOLUTION
from portolan_testing.waiting import eventually

# Transforms may take their time on a busy machine; maps are small.
MAPPER = {"tf_wait": 30.0, "publish_interval": 0.05, "diagnostic_period": 0.1}
DEFAULTS = {"occupancy_grid": {**MAPPER, "resolution": RESOLUTION}, "robot_sim": {}}
PACKAGES = {"robot_sim": "portolan_sim"}


def executable(name, package="portolan_ros"):
    """The path of a program of this package."""
    found = roslib.packages.find_node(package, name)
    assert found, f"{package} has no program {name}"
    return found[0] if isinstance(found, list) else found


class Tally:
    """What diagnostics say became of the messages of one input."""

    def __init__(self, noun, values, sentence):
        self.received = int(values.get(noun + " received", 0))
        self.used = int(values.get(noun + " used", 0))
        begin = noun + " dropped: "
        self.dropped = {key[len(begin):]: int(count) for key, count in values.items() if key.startswith(begin)}
        parts = re.split(r"; (?=\d+ of |no \w+ received)", sentence)
        self.sentence = next((part for part in parts if f" {noun} " in part), "")
        self.waiting = self.received - self.used - sum(self.dropped.values())

    def __repr__(self):
        return f"{self.used} of {self.received} used, {self.waiting} wait, dropped {self.dropped}"


class Node:
    """A node of ours; topics of tf and clock are those of its namespace unless `remap` says otherwise."""

    def __init__(self, namespace, program="occupancy_grid", parameters=None, remap=None, preexec=None,
                 until_ready=True):
        self.namespace = namespace
        self.name = f"{namespace}/{program}"
        if rospy.has_param(self.name):
            rospy.delete_param(self.name)
        rospy.set_param(self.name, {**DEFAULTS.get(program, MAPPER), **(parameters or {})})
        names = {f"/{topic}": f"{namespace}/{topic}" for topic in ("tf", "tf_static", "clock")}
        names.update(remap or {})
        self._errors = tempfile.TemporaryFile()
        self._status = None
        self._clock = None
        self._diagnostics = rospy.Subscriber("/diagnostics", DiagnosticArray, self._take_diagnostics)
        self.process = subprocess.Popen(
            [executable(program, PACKAGES.get(program, "portolan_ros")), f"__ns:={namespace}", f"__name:={program}"]
            + [f"{old}:={new}" for old, new in names.items()],
            stdout=subprocess.DEVNULL, stderr=self._errors, preexec_fn=preexec)
        if until_ready:
            self._wait_until_ready()

    def _wait_until_ready(self):
        def is_ready():
            assert self.process.poll() is None, f"the node ended: {self.errors()}"
            try:
                rospy.wait_for_service(self.name + "/reset", timeout=0.5)
                return True
            except rospy.ROSException:
                return False
        eventually(is_ready, "the node's services are there")

    def _take_diagnostics(self, message):
        for status in message.status:
            if status.name == f"{self.name[1:]}: mapping":
                self._status = status
                self._clock = message.header.stamp.to_sec()

    def errors(self):
        """What it wrote to stderr so far."""
        self._errors.seek(0)
        return self._errors.read().decode()

    def exit_code(self):
        """Waits for its end."""
        eventually(lambda: self.process.poll() is not None, "the process ends")
        return self.process.returncode

    def call(self, service):
        """A Trigger service of its own: save, load or reset."""
        return rospy.ServiceProxy(f"{self.name}/{service}", Trigger)()

    def map(self, service="dynamic_map"):
        """The whole grid, as the service gives it."""
        return Grid(rospy.ServiceProxy(f"{self.namespace}/{service}", GetMap)().map)

    def clock(self):
        """The time [s] that it has, as of its last diagnostics; None while there are none."""
        return self._clock

    def sentence(self):
        """The line of its diagnostics; empty while there is none."""
        return self._status.message if self._status else ""

    def level(self):
        return self._status.level if self._status else None

    def values(self):
        return {item.key: item.value for item in self._status.values} if self._status else {}

    def tally(self, noun):
        status = self._status
        values = {item.key: item.value for item in status.values} if status else {}
        return Tally(noun, values, status.message if status else "")

    def wait_for(self, noun, **wanted):
        """Until diagnostics say so many received, used, or dropped for a reason; gives the tally."""
        def has_come():
            tally = self.tally(noun)
            found = {"received": tally.received, "used": tally.used, "waiting": tally.waiting, **tally.dropped}
            return tally if all(found.get(key, 0) == count for key, count in wanted.items()) else None
        return eventually(has_come, lambda: f"{noun} {wanted}; they are {self.tally(noun)}, {self.sentence()}")

    def kill(self):
        self.process.kill()
        self.process.wait()

    def close(self):
        self._diagnostics.unregister()
        if self.process.poll() is None:
            self.process.terminate()
            try:
                self.process.wait(timeout=10.0)
            except subprocess.TimeoutExpired:
                self.kill()
        self._errors.close()
