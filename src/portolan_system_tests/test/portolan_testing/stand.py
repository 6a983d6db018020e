# SPDX-License-Identifier: BSD-3-Clause
"""A test stand: a robot on its round, behind it the fault injector, behind that one of the nodes."""
import pathlib
import signal
import subprocess
import time

import rospy
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import Odometry
from rosgraph_msgs.msg import Clock
from std_srvs.srv import Trigger

from portolan_testing import messages
from portolan_testing.grid import files_of
from portolan_testing.injection import Injector, is_cut, stamp_of
from portolan_testing.node import Node, executable
from portolan_testing.robot import TOPICS, Robot, heard_by
from portolan_testing.subjects import SUBJECTS, pose_of
from portolan_testing.waiting import eventually

STEPS = 10     # in each part of the round
STEP = 0.1     # [s]
PAUSE = 2.0    # between two parts: longer than messages wait for tf [s]
TAIL = 6       # transforms after the last step of a part, where they are delayed
PARTS = "ABC"  # faults are injected in B
DELAYED = ("tf_late", "rate_ten_times_too_high")  # faults that move messages to after the last step


class Part:
    """A part of the round from `begin` [s] on: what sensors say, and where they were, as tf or as odometry."""

    def __init__(self, subject, name, begin, tail):
        steps = [(PARTS.index(name) * STEPS + i, begin + STEP * i) for i in range(STEPS)]
        self.begin = begin
        self.looks = [pair for step, stamp in steps for pair in subject.look(step, stamp)]
        (first, _), (last, end) = steps[0], steps[-1]
        steps = [(first, begin - STEP)] + steps + [(last, end + STEP * i) for i in range(1, tail + 1)]
        self.poses = [("tf", messages.transforms(messages.transform(stamp, "odom", "base_link", pose_of(step))))
                      for step, stamp in steps]
        self.odometry = [("odom", messages.odometry(stamp, "odom", "base_link", pose_of(step)))
                         for step, stamp in steps]


def ignore_full_files():
    """A file that grows too large is an error like any other, as on a full disk."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)


class Stand:
    def __init__(self, program, folder, namespace):
        self.subject, self.program, self.namespace = SUBJECTS[program], program, namespace
        self.folder = pathlib.Path(folder)
        self.node, self.now = None, 1000.0
        self.injector = f"{namespace}/fault_injector"
        self._injector = subprocess.Popen([executable("fault_injector.py", "portolan_system_tests"),
                                           f"__ns:={namespace}"], stdout=subprocess.DEVNULL)
        self.robot = Robot(namespace + "/raw", tf="tf", tf_static="tf_static")
        self.robot.wait_until_heard((*heard_by(program), "odom", "clock"))
        self.start_node()
        self._maps = {}

    def start_node(self, **parameters):
        """The node, or it anew; it is heard from then on."""
        if self.node:
            self.node.close()
        # Topics need not wait for each other: the clock stands from one part to the next.
        parameters = {"tf_wait": 1.0, "order_wait": 0.0, "odom_topic": "odom", "diagnostic_period": 0.05,
                      "map_directory": str(self.folder), **self.subject.parameters, **parameters}
        self.node = Node(self.namespace, self.program, parameters=parameters, preexec=ignore_full_files)
        rospy.wait_for_service(self.injector + "/inject")
        self.inject("none", 0.0, 0.0)
        self._probe()
        self._tallies = {noun: self.node.tally(noun) for noun in self.subject.nouns.values()}

    def _probe(self):
        """Sends what is refused, again and again, until the node has got some of it by every topic."""
        def arrives(topic, message, count):
            before = count()

            def has_come():
                self.robot.send(topic, message)
                end = time.monotonic() + 0.3
                while count() == before and time.monotonic() < end:
                    time.sleep(0.01)
                return count() > before
            eventually(has_come, f"{topic} reaches the node")
        for topic, noun in self.subject.nouns.items():
            arrives(topic, TOPICS[topic](), lambda noun=noun: self.node.tally(noun).received)
        for topic, message in (("tf", messages.transforms(TransformStamped())), ("odom", Odometry())):
            arrives(topic, message, lambda: int(self.node.values().get("transforms refused", 0)))

    def inject(self, fault, begin, end):
        for name, value in (("fault", fault), ("begin", begin), ("end", end)):
            rospy.set_param(f"{self.injector}/{name}", value)
        rospy.ServiceProxy(self.injector + "/inject", Trigger)()

    def since(self, noun):
        """What became of this input's messages since `play` began: (received, used, waiting, dropped by reason)."""
        before, now = self._tallies[noun], self.node.tally(noun)
        dropped = {reason: n - before.dropped.get(reason, 0) for reason, n in now.dropped.items()}
        return (now.received - before.received, now.used - before.used, now.waiting,
                {reason: n for reason, n in dropped.items() if n})

    def is_settled(self, received=None):
        """All that was sent has been received, and, where no numbers are given, nothing waits."""
        fates = {noun: self.since(noun) for noun in self._tallies}
        if received is None:
            return all(fate[2] == 0 for fate in fates.values())
        return all(fates[noun][0] >= count for noun, count in received.items())

    def settle(self):
        eventually(self.is_settled, lambda: f"nothing waits: {self.node.sentence()}")

    def _tick(self, injector, now):
        clock, = injector("clock", Clock(messages.time(now)))
        self.robot.tick(now)
        eventually(lambda: self.node.clock() == stamp_of(clock), lambda: f"{stamp_of(clock)}, not {self.node.clock()}")
        self.settle()
        return stamp_of(clock)

    def play(self, fault="none", parts=PARTS, looks=PARTS, poses_first=False, posed=True, by="poses"):
        """The round with the fault in part B; only `parts` of it, with sensors only in `looks`. Sensors of part B
        are waited for where they can be `posed`, `by` "poses" or "odometry". Gives how many messages the node gets
        of each input."""
        begin = {name: self.now + (PAUSE + STEPS * STEP) * i for i, name in enumerate(PARTS)}
        window = (begin["B"] - 1.5 * STEP, begin["C"] - 1.5 * STEP)
        self.inject(fault, *window)
        model = Injector(fault, *window)
        self._tick(model, self.now - 1.0)
        self._tallies = {noun: self.node.tally(noun) for noun in self.subject.nouns.values()}
        received = dict.fromkeys(self._tallies, 0)
        for name in parts:
            part = Part(self.subject, name, begin[name], TAIL if fault in DELAYED else 0)
            self._tick(model, part.begin)
            looks_now = part.looks if name in looks else []
            where = getattr(part, by)
            for batch in [where, looks_now] if poses_first else [looks_now, where]:
                self._send(model, batch, received)
            if posed or name != "B":
                self.settle()
        end = self._tick(model, begin["C"] + PAUSE + 2 * STEPS * STEP)
        self.now = end + 5.0
        return received

    def _send(self, model, batch, received):
        for topic, message in batch:
            for broken in model(topic, message):
                if topic in self.subject.nouns and not is_cut(broken):
                    received[self.subject.nouns[topic]] += 1
            self.robot.send(topic, message)
        eventually(lambda: self.is_settled(received), lambda: f"received {received}: {self.node.sentence()}")

    def saved(self):
        """The files of a save that succeeds, as far as they tell nothing of when."""
        answer = self.node.call("save")
        assert answer.success, answer.message
        return files_of(self.folder, self.subject.files)

    def map_of(self, parts, looks=PARTS):
        """What a round without faults leaves."""
        if (parts, looks) not in self._maps:
            self.node.call("reset")
            self.play(parts=parts, looks=looks)
            self._maps[parts, looks] = self.saved()
        return self._maps[parts, looks]

    def close(self):
        self.robot.close()
        if self.node:
            self.node.close()
        self._injector.terminate()
        self._injector.wait()
