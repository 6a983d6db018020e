#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What clouds, tf and users get wrong for the octomap node: counted, named, and the node maps on."""
import math
import struct

import rospy
from octomap_msgs.srv import GetOctomap
from sensor_msgs.msg import PointField

from portolan_testing import case, hall, messages
from portolan_testing.octree import Octree
from portolan_testing.waiting import eventually

HERE = (0.0, 0.0, 0.0)
MOST = 2**32 - 1
NAN, INF = math.nan, math.inf


def changed(message, **fields):
    for name, value in fields.items():
        setattr(message, name, value)
    return message


def cloud(stamp, points=((1.05, 0.05, 0.05),), frame="camera", **fields):
    return changed(messages.cloud(stamp, frame, points), **fields)


def big_endian_doubles(stamp, points):
    """The same points in another layout: doubles, most significant byte first, with colours and padding."""
    message = messages.cloud(stamp, "camera", points)
    message.is_bigendian, message.point_step = True, 40
    message.height, message.width = 2, len(points) // 2
    message.row_step = 40 * message.width + 3
    message.fields = [PointField("rgb", 0, PointField.FLOAT32, 1)] + [
        PointField(name, 9 + 8 * i, PointField.FLOAT64, 1) for i, name in enumerate("xyz")]
    rows = (points[:message.width], points[message.width:])
    message.data = b"".join(b"".join(struct.pack(">9x3d7x", *p) for p in row) + b"\x7f" * 3 for row in rows)
    return message


MALFORMED = [
    dict(fields=[]), dict(fields=[PointField(n, 4 * i, PointField.INT8, 1) for i, n in enumerate("xyz")]),
    dict(fields=[PointField(n, 4 * i, PointField.FLOAT32, 1) for i, n in enumerate("xy")]),
    dict(fields=[PointField(n, MOST, PointField.FLOAT32, 1) for n in "xyz"]), dict(data=b""), dict(data=b"1234567"),
    dict(width=2), dict(width=MOST), dict(height=MOST), dict(row_step=MOST, height=3), dict(point_step=0),
    dict(point_step=MOST), dict(row_step=0)]


class OctomapFaults(case.NodeCase):
    def octomap(self, **parameters):
        robot, node = self.pair(program="octomap", parameters={"resolution": 0.1, "tf_wait": 1.0, **parameters})
        robot.tick(1000.0)
        robot.stand(990.0, HERE)
        robot.stand(1010.0, HERE)
        return robot, node

    def tree(self, node):
        return Octree.of(rospy.ServiceProxy(f"{node.namespace}/octomap_full", GetOctomap)().map)

    def test_clouds_of_all_kinds(self):
        robot, node = self.octomap()
        for i, fault in enumerate(MALFORMED):
            robot.send("cloud_in", cloud(1000.0 + 0.01 * i, **fault))
        node.wait_for("clouds", malformed=len(MALFORMED), used=0)
        self.assertFalse(self.tree(node).leaves)
        robot.send("cloud_in", cloud(1001.0, points=()))
        robot.send("cloud_in", cloud(1001.1, points=[(NAN, NAN, NAN), (INF, 0.0, 0.0), (0.0, -INF, NAN)] * 50))
        node.wait_for("clouds", used=2)
        self.assertFalse(self.tree(node).leaves, "nothing finite, nothing known")
        far = [(5e3, 0.0, 0.0), (0.0, -1e30, 0.0), (0.0, 0.0, 3.4e38), (-3276.9, 0.0, 0.0)] * 5000
        robot.send("cloud_in", cloud(1001.2, points=far))
        node.wait_for("clouds", used=3)
        eventually(lambda: node.values().get("points outside of the octree") == str(len(far)), "they are counted")
        self.assertFalse(self.tree(node).voxels(True))
        points = hall.walls()
        robot.send("cloud_in", cloud(1001.3, points=points + [(NAN, 1.0, 1.0)]))
        node.wait_for("clouds", used=4)
        expected = self.tree(node)
        self.assertEqual(len(expected.voxels(True)), len(set(points)))
        node.call("reset")
        robot.send("cloud_in", big_endian_doubles(1002.0, points))
        node.wait_for("clouds", used=5)
        self.assertEqual(self.tree(node).leaves, expected.leaves, "another layout of the same points")
        eventually(lambda: node.values().get("points that hit") == str(len(points)), "the points are counted")
        self.assertLess(len(node.errors().splitlines()), 20, "no flood of lines")

    def refused(self, **parameters):
        """What the node says before it ends."""
        node = self.node(self.new_namespace(), program="octomap", until_ready=False, parameters=parameters)
        self.assertGreater(node.exit_code(), 0)
        return node.errors()

    def test_parameters(self):
        words = self.refused(resolution=-0.1, sensor_model={"hit": 0.3, "mis": 0.4}, pointcloud_min_z=2.0,
                             pointcloud_max_z=1.0, occupancy_min_z=1.0, occupancy_max_z=0.0, latch=True)
        self.assert_in_words(["resolution", "sensor_model/hit", "sensor_model/mis", "pointcloud_min", "occupancy_min_z",
                              "latch"], words)
        self.assertIn("max_range", self.refused(no_return="clear"))


if __name__ == "__main__":
    case.run("octomap_faults", OctomapFaults)
