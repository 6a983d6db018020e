#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A drift correction bends the map of the grid node; a bad one does not touch it."""
import math

from portolan_testing import case, messages
from portolan_testing.room import Room
from portolan_testing.waiting import eventually

OCCUPIED, FREE = 65, 35
WAY = [(1000.0 + 0.1 * i, (0.02 * i, 0.01 * i, 0.03 * i)) for i in range(12)]  # stamp, pose (x, y, yaw)
DRIFT = [(1000.0, (0.0, 0.0, 0.0)), (1000.5, (0.4, -0.2, 0.3)), (1001.0, (1.1, 0.3, -0.5))]


class GridBends(case.NodeCase):
    def walk(self, robot):
        for stamp, pose in WAY:
            robot.look(Room(), stamp, pose)

    def wait_for_all(self, robot, node):
        node.wait_for("scans", used=robot.sent["scan"])
        node.wait_for("echoes", used=robot.sent["sonar"])

    def test_the_map_moves_with_the_correction(self):
        robot, node = self.pair()
        listener = self.listener()
        robot.look_around(Room(), [stamp for stamp, _ in WAY])
        self.wait_for_all(robot, node)
        eventually(lambda: listener.at(2.05, 0.05) > OCCUPIED, "the wall is where odometry says")
        robot.send("drift_correction", messages.correction([(1000.0, (1.0, 0.0, 0.0))]))
        eventually(lambda: listener.at(3.05, 0.05) > OCCUPIED, "the wall has moved")
        self.assertLess(listener.at(2.05, 0.05), FREE, "where it was is free")
        self.assertEqual(listener.at(-2.05, 0.05), -1, "the opposite wall has moved too")
        eventually(lambda: listener.known() == node.map().known(), "topic and service agree")

    def test_what_comes_after_a_correction_is_drawn_by_it(self):
        robot, node = self.pair()
        listener = self.listener()
        robot.send("drift_correction", messages.correction([(1000.0, (1.0, 0.0, 0.0))]))
        robot.look(Room(), 999.0)
        eventually(lambda: listener.at(3.05, 0.05) > 50, "the correction is in force")
        robot.look_around(Room(), [stamp for stamp, _ in WAY])
        self.wait_for_all(robot, node)
        eventually(lambda: listener.at(3.05, 0.05) > OCCUPIED, "the wall is where the correction says")

    def test_late_correction_equals_early_correction(self):
        early, late = self.namespace, self.new_namespace()
        early_robot, late_robot = self.robot(early), self.robot(late)
        early_robot.send("drift_correction", messages.correction(DRIFT))
        early_node, late_node = self.node(early), self.node(late)
        for robot in (early_robot, late_robot):
            robot.wait_until_heard()
            self.walk(robot)
        self.wait_for_all(early_robot, early_node)
        self.wait_for_all(late_robot, late_node)
        straight = self.saved(late_node)
        late_robot.send("drift_correction", messages.correction([(1000.0, (0.3, 0.3, 1.0))]))
        late_robot.send("drift_correction", messages.correction(DRIFT))
        eventually(lambda: self.saved(late_node) == self.saved(early_node), "the maps' files are equal")
        self.assertNotEqual(self.saved(late_node), straight)
        self.assertEqual(set(straight), {"map.pgm", "map.yaml", "map_laser.pgm", "map_laser.yaml",
                                         "map_sonar.pgm", "map_sonar.yaml"})

    def test_an_empty_correction_takes_the_last_one_back(self):
        robot, node = self.pair()
        self.walk(robot)
        self.wait_for_all(robot, node)
        straight = self.saved(node)
        robot.send("drift_correction", messages.correction(DRIFT))
        eventually(lambda: self.saved(node) != straight, "the map is bent")
        robot.send("drift_correction", messages.correction([]))
        eventually(lambda: self.saved(node) == straight, "the map is straight again")

    def test_a_thousand_corrections_end_in_the_last_one(self):
        robot, node = self.pair()
        self.walk(robot)
        for i in range(1000):
            robot.send("drift_correction", messages.correction([(1000.0, (0.001 * (i + 1), 0.0, 0.0))]))
        self.wait_for_all(robot, node)
        listener = self.listener()
        eventually(lambda: listener.at(3.05, 0.05) > OCCUPIED, "the map rests where the last one says")
        eventually(lambda: listener.known() == node.map().known(), "topic and service agree")

    def test_bad_corrections_are_refused_and_counted(self):
        robot, node = self.pair()
        self.walk(robot)
        self.wait_for_all(robot, node)
        before = self.saved(node)
        for count, bad in enumerate(bad_corrections(), start=1):
            robot.send("drift_correction", bad)
            eventually(lambda: node.values().get("corrections refused") == str(count), f"number {count} is refused")
            self.assertEqual(self.saved(node), before)
        robot.send("drift_correction", messages.correction(DRIFT))
        eventually(lambda: self.saved(node) != before, "a good one still bends the map")


def bad_corrections():
    fewer_poses = messages.correction(DRIFT)
    fewer_poses.poses.pop()
    fewer_stamps = messages.correction(DRIFT)
    fewer_stamps.stamps = []
    not_a_number = messages.correction(DRIFT)
    not_a_number.poses[1].position.x = math.nan
    no_rotation = messages.correction(DRIFT)
    no_rotation.poses[2].orientation.w = no_rotation.poses[2].orientation.z = 0.0
    long_rotation = messages.correction(DRIFT)
    long_rotation.poses[0].orientation.w = 3.0
    return [fewer_poses, fewer_stamps, not_a_number, no_rotation, long_rotation,
            messages.correction(list(reversed(DRIFT))), messages.correction([DRIFT[0], DRIFT[0]]),
            messages.correction(DRIFT, child="odometry"), messages.correction(DRIFT, child="")]


if __name__ == "__main__":
    case.run("grid_bends", GridBends)
