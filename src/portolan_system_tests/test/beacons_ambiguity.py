#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 11 of the chapter: a simulated robot drives straight, and a beacon is one of two mirror images; it turns, and one is left."""
import math
import threading

import numpy
import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from portolan_msgs.msg import BeaconRanges

from portolan_testing import beacons, case
from portolan_testing.node import Node
from portolan_testing.waiting import eventually

TRUTH = (4.0, 3.0)
SIMULATOR = {
    "seed": 11, "drive": "command", "command_timeout": 0.0, "real_time_factor": 8.0,
    "wait_for_subscribers": ["beacon_ranges"], "lasers": [], "sonar_rings": [],
    "odometry": {"alpha1": 0.0, "alpha2": 0.0, "alpha3": 0.0, "alpha4": 0.0},
    "world": {"beacons": [{"id": 6, "position": [TRUTH[0], TRUTH[1], 0.0]}]},
    "beacon_receivers": [{"frame": "antenna", "topic": "beacon_ranges", "rate": 5, "position": [0.2, 0.0, 0.0]}]}


class Driver:
    """Drives the simulated robot, and counts what it hears."""

    def __init__(self, namespace):
        self._lock = threading.Lock()
        self._ranges = 0
        self._pose = None
        self._speed = 0.0
        self._commands = rospy.Publisher(f"{namespace}/cmd_vel", Twist, queue_size=10)
        self._subscribers = [rospy.Subscriber(f"{namespace}/beacon_ranges", BeaconRanges, self._hear),
                             rospy.Subscriber(f"{namespace}/ground_truth", Odometry, self._move)]

    def _hear(self, message):
        with self._lock:
            self._ranges += len(message.ranges)

    def heard(self):
        with self._lock:
            return self._ranges

    def _move(self, message):
        self._pose = message.pose.pose.position
        self._speed = math.hypot(message.twist.twist.linear.x, message.twist.twist.angular.z)

    def drive(self, speed, turn_rate, until):
        """Until the true position fulfils the condition; then it stands still."""
        eventually(lambda: self._commands.get_num_connections() > 0, "the simulator takes commands")
        self._command(speed, turn_rate)
        eventually(lambda: self._pose is not None and until(self._pose), "the robot is there", seconds=120.0)
        self._command(0.0, 0.0)
        eventually(lambda: self._speed == 0.0, "the robot stands")

    def _command(self, speed, turn_rate):
        command = Twist()
        command.linear.x, command.angular.z = speed, turn_rate
        self._commands.publish(command)

    def close(self):
        self._commands.unregister()
        for subscriber in self._subscribers:
            subscriber.unregister()


class BeaconsAmbiguity(beacons.BeaconCase):
    def settled(self, listener, driver):
        """The beacon once all ranges that came so far are in the map; more come while the robot stands."""
        least = driver.heard()
        eventually(lambda: listener.taken() >= least, lambda: f"{least} ranges are mapped, not {listener.taken()}")
        return listener.beacon(6)

    def test_figure_11(self):
        driver = self.closing(Driver(self.namespace))
        self.node(parameters={"drift": 0.0, "calibration": {"scale_stddev": 0.0, "bias_stddev": 0.0, "turn_stddev": 0.0}})
        listener = self.listener()
        self.closing(Node(self.namespace, program="robot_sim", parameters=SIMULATOR))

        driver.drive(0.6, 0.0, until=lambda p: p.x > 6.0)
        beacon = self.settled(listener, driver)
        self.assertEqual(len(beacon.weights), 2)
        self.assertLess(abs(beacon.weights[0] - 0.5), 0.1)
        self.assertTrue(beacon.message.ambiguous)
        numpy.testing.assert_allclose(beacon.means[0], beacon.means[1] * (1.0, -1.0), atol=0.01)
        self.assertLess(min(beacon.sigmas(TRUTH, mode) for mode in (0, 1)), 3.0)
        drive = beacon.message.drive
        self.assertGreater(abs(drive.direction.y), abs(drive.direction.x), "to the side, to tell the two apart")
        self.assertGreater(drive.expected_information, 0.4)

        driver.drive(0.6, 0.5, until=lambda p: p.y > 2.0)
        beacon = self.settled(listener, driver)
        self.assertEqual(len(beacon.weights), 1)
        self.assertFalse(beacon.message.ambiguous)
        self.assertLess(beacon.sigmas(TRUTH), 3.0)
        self.assertLess(beacon.error(TRUTH), 0.2)


if __name__ == "__main__":
    case.run("beacons_ambiguity", BeaconsAmbiguity)
