#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Two simulated robots in one master, with one clock and one tf, map their own rooms and do not disturb each other."""
import rospy
from std_msgs.msg import Bool

from portolan_testing import case
from portolan_testing.node import Node
from portolan_testing.waiting import eventually

OCCUPIED, FREE = 65, 20  # map_server's thresholds [%]
SHARED = {"/tf": "/tf", "/tf_static": "/tf_static", "/clock": "/clock"}


def rectangle(half_length, half_width):
    """The walls of a room about the origin; their inner sides are this far from it [m]."""
    x, y = half_length + 0.05, half_width + 0.05
    return [{"points": [[-x, -y], [x, -y], [x, y], [-x, y], [-x, -y]], "thickness": 0.1}]


class SimulatedRobot:
    """One robot with its own namespace, prefix and room, and the node that maps it."""

    def __init__(self, test, number, half_length, half_width):
        self.namespace, self.prefix = f"/robot_{number}", f"robot_{number}/"
        self.finished = False
        self._test = test
        self._room = rectangle(half_length, half_width)
        self._first = number == 0
        frames = {"odom_frame": self.prefix + "odom", "base_frame": self.prefix + "base_link"}
        self.mapper = test.node(self.namespace, parameters=frames, remap=SHARED)
        subscriber = rospy.Subscriber(self.namespace + "/path_finished", Bool, self._take_finished)
        test.addCleanup(subscriber.unregister)

    def start(self):
        self._test.closing(Node(self.namespace, program="robot_sim", remap=SHARED, until_ready=False, parameters={
            "frame_prefix": self.prefix, "publish_clock": self._first, "real_time_factor": 5.0,
            "wait_for_subscribers": ["scan", "sonar"], "seed": 3, "world": {"walls": self._room},
            "path": [[-0.8, 0.0], [0.8, 0.0], [0.8, 0.3]] if self._first else [[-0.8, 0.0], [0.5, 0.0]]}))

    def _take_finished(self, message):
        self.finished = message.data


class TwoRobots(case.NodeCase):
    def test_each_maps_its_own_room(self):
        robots = [SimulatedRobot(self, 0, 2.0, 1.5), SimulatedRobot(self, 1, 3.0, 1.0)]
        for robot in reversed(robots):  # the first one makes the clock, and drives on when the other stands
            robot.start()
        eventually(lambda: all(robot.finished for robot in robots), "both have driven their paths")
        for robot in robots:
            scans = eventually(lambda r=robot: r.mapper.tally("scans").used and r.mapper.tally("scans"), "scans are used")
            self.assertEqual(sum(scans.dropped.values()), 0, scans)
        grids = [robot.mapper.map() for robot in robots]
        for grid, (x, y) in zip(grids, ((2.05, 1.55), (3.05, 1.05))):
            self.assertGreater(max(grid.at(x - 0.05, 0.02), grid.at(x, 0.02)), OCCUPIED)
            self.assertGreater(max(grid.at(0.02, y - 0.05), grid.at(0.02, y)), OCCUPIED)
        self.assertTrue(0 <= grids[0].at(0.02, 1.2) < FREE, "free in the first room, behind the second's wall")
        self.assertTrue(0 <= grids[1].at(2.5, 0.02) < FREE, "free in the second room, behind the first's wall")
        self.assertTrue(robots[0].mapper.call("reset").success)
        self.assertEqual(robots[1].mapper.map().known(), grids[1].known())


if __name__ == "__main__":
    case.run("two_robots", TwoRobots)
