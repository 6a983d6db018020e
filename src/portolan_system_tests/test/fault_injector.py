#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Stands between a bag, a simulator or a robot and the mappers, and breaks what it passes on, always in the same way.

It hears `raw/scan`, `raw/tf`, `raw/clock` and so on, and sends `scan`, `tf`, `clock`. Messages are broken whose stamps
lie from ~begin to before ~end [s]; ~fault says how: one of the names of portolan_testing.injection.FAULTS.
~inject reads the three anew."""
import math
import threading

import rospy
from nav_msgs.msg import Odometry
from portolan_msgs.msg import DriftCorrection
from rosgraph_msgs.msg import Clock
from std_srvs.srv import Trigger, TriggerResponse

from portolan_testing.injection import FAULTS, Injector
from portolan_testing.robot import TOPICS

ALL = {**TOPICS, "odom": Odometry, "clock": Clock, "drift_correction": DriftCorrection}
LATCHED = ("tf_static", "clock", "drift_correction")


class FaultInjector:
    def __init__(self):
        self._lock = threading.Lock()
        self._injector = self._read()
        self._publishers = {topic: rospy.Publisher(topic, type_, queue_size=10000, tcp_nodelay=True,
                                                   latch=topic in LATCHED) for topic, type_ in ALL.items()}
        self._subscribers = [rospy.Subscriber("raw/" + topic, type_, self._pass_on, topic, tcp_nodelay=True)
                             for topic, type_ in ALL.items()]
        self._service = rospy.Service("~inject", Trigger, self._inject)

    def _read(self):
        fault = rospy.get_param("~fault", "none")
        if fault not in FAULTS:
            raise ValueError(f"~fault must be one of {', '.join(FAULTS)}")
        return Injector(fault, rospy.get_param("~begin", 0.0), rospy.get_param("~end", math.inf))

    def _pass_on(self, message, topic):
        with self._lock:
            for broken in self._injector(topic, message):
                self._publishers[topic].publish(broken)

    def _inject(self, _):
        with self._lock:
            self._injector = self._read()
        return TriggerResponse(True, "")


if __name__ == "__main__":
    rospy.init_node("fault_injector")
    FaultInjector()
    rospy.spin()
