# SPDX-License-Identifier: BSD-3-Clause
"""Beacons, a robot that hears them, and the map that the node makes of it."""
import math

import numpy
import rospy
from portolan_msgs.msg import BeaconMap

from portolan_testing import case, messages
from portolan_testing.robot import ANTENNA


class Beacon:
    """One beacon of a message, with numbers as arrays in the plane."""

    def __init__(self, message):
        self.message = message
        self.weights = [mode.weight for mode in message.modes]
        self.means = [numpy.array([mode.position.x, mode.position.y]) for mode in message.modes]
        self.covariances = [numpy.array(mode.covariance).reshape(3, 3)[:2, :2] for mode in message.modes]

    def sigmas(self, truth, mode=0):
        """Mahalanobis distance of the truth (x, y) from a mode."""
        step = numpy.array(truth) - self.means[mode]
        return math.sqrt(step @ numpy.linalg.solve(self.covariances[mode], step))

    def error(self, truth):
        return float(numpy.linalg.norm(self.means[0] - numpy.array(truth)))


class BeaconListener:
    """The latched map as it comes."""

    def __init__(self, topic):
        self.last = None
        self._subscriber = rospy.Subscriber(topic, BeaconMap, self._take)

    def _take(self, message):
        self.last = message

    def taken(self):
        """How many ranges the map holds; -1 while none has come."""
        return self.last.ranges_taken if self.last else -1

    def beacon(self, id_):
        """The beacon of this id, None where the map has none."""
        message = next((b for b in self.last.beacons if b.id == id_), None) if self.last else None
        return Beacon(message) if message else None

    def close(self):
        self._subscriber.unregister()


class BeaconCase(case.NodeCase):
    """Starts nodes of the beacons' map."""

    files = "beacons"

    def node(self, namespace=None, program="beacons", **more):
        return super().node(namespace, program=program, **more)

    def pair(self, namespace=None, program="beacons", **more):
        return super().pair(namespace, program=program, **more)

    def listener(self, topic="beacons", namespace=None):
        return self.closing(BeaconListener(f"{namespace or self.namespace}/{topic}"))


def antenna_at(pose):
    """Where the antenna is (x, y) when the base is at pose (x, y, yaw)."""
    x, y, yaw = pose
    c, s = math.cos(yaw), math.sin(yaw)
    return (x + c * ANTENNA[0] - s * ANTENNA[1], y + s * ANTENNA[0] + c * ANTENNA[1])


def heard_from(beacons, pose):
    """Exact ranges, pairs (id, range), to beacons {id: (x, y)} from the antenna of a base at this pose."""
    here = antenna_at(pose)
    return [(id_, math.hypot(x - here[0], y - here[1])) for id_, (x, y) in beacons.items()]


def way(step):
    """Pose on a circle of 2 m about (0, 2), which no mirror image survives."""
    yaw = 0.16 * step
    return (2.0 * math.sin(yaw), 2.0 - 2.0 * math.cos(yaw), yaw)


def stamp_of(step):
    return 1000.0 + 0.1 * step


def drive(robot, beacons, steps, seen_as=lambda pose: pose):
    """Goes along the way and hears the beacons; `seen_as(pose)` is what odometry says."""
    for step in steps:
        pose = way(step)
        robot.stand(stamp_of(step), seen_as(pose))
        robot.send("beacon_ranges", messages.ranges(stamp_of(step), "antenna", heard_from(beacons, pose)))
