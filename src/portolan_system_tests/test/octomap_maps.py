#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The octomap node: what it shows agrees in all outputs, bends, is cleared, forgotten, saved and loaded."""
import subprocess

import rosbag
import rospy
from geometry_msgs.msg import Point
from nav_msgs.msg import OccupancyGrid
from octomap_msgs.msg import Octomap
from octomap_msgs.srv import BoundingBoxQuery, GetOctomap
from sensor_msgs.msg import PointCloud2

from portolan_testing import bags, case, hall, messages
from portolan_testing.grid import Grid, png_size
from portolan_testing.node import executable
from portolan_testing.octree import Cubes, Latest, Octree, voxels_of_cloud
from portolan_testing.robot import mounts
from portolan_testing.room import Room
from portolan_testing.waiting import eventually

R = hall.RESOLUTION
OPTIONS = {"resolution": R, "sensor_model": {"max_range": 8.0}, "tree_interval": 0.05}
WAY = [(1000.0 + 0.1 * i, (0.02 * i, 0.01 * i, 0.03 * i)) for i in range(8)]  # stamp, pose (x, y, yaw)


def cloud(stamp, pose, points=None):
    return messages.cloud(stamp, "camera", hall.seen_from(pose, points))


class OctomapMaps(case.NodeCase):
    def octomap(self, namespace=None, **parameters):
        """A robot, and an octomap node that hears it."""
        return self.pair(namespace, program="octomap", parameters={**OPTIONS, **parameters})

    def latest(self, node, topic, type_=Octomap):
        return self.closing(Latest(f"{node.namespace}/{topic}", type_))

    def walk(self, robot, node, way=WAY):
        for stamp, pose in way:
            robot.stand(stamp, pose)
            robot.send("cloud_in", cloud(stamp, pose))
        node.wait_for("clouds", used=robot.sent["cloud_in"])

    def tree(self, node, service="octomap_full"):
        return Octree.of(rospy.ServiceProxy(f"{node.namespace}/{service}", GetOctomap)().map)

    def clear(self, node, low, high):
        rospy.ServiceProxy(f"{node.name}/clear_bbx", BoundingBoxQuery)(Point(*low), Point(*high))

    def test_all_outputs_show_the_same(self):
        self.assertEqual(Octomap._md5sum, "9a45536b45c5e409cd49f04bb2d9999f")
        robot, node = self.octomap(projection_min_z=-0.3, projection_max_z=0.2)
        full, binary = self.latest(node, "octomap_full"), self.latest(node, "octomap_binary")
        centres = self.latest(node, "octomap_point_cloud_centers", PointCloud2)
        projected = self.latest(node, "projected_map", OccupancyGrid)
        cubes = self.closing(Cubes(f"{node.namespace}/occupied_cells_vis_array"))
        self.walk(robot, node)
        tree = self.tree(node)
        eventually(lambda: full.message and Octree.of(full.message).leaves == tree.leaves, "the topic is as the service")
        self.assertGreater(tree.at(2.05, 0.05, 0.05), 0.0, "a wall")
        self.assertLess(tree.at(1.05, 0.05, 0.05), 0.0, "free space")
        self.assertIsNone(tree.at(2.95, 0.05, 0.05), "behind the wall")
        self.assertEqual(tree.resolution, R)
        occupied = tree.voxels(occupied=True)
        self.assertGreater(len(occupied), 1000)
        eventually(lambda: binary.message and Octree.of(binary.message).voxels(True) == occupied, "the binary topic")
        self.assertEqual(Octree.of(binary.message).voxels(False), tree.voxels(False))
        self.assertEqual(self.tree(node, "octomap_binary").leaves, Octree.of(binary.message).leaves)
        eventually(lambda: centres.message and voxels_of_cloud(centres.message, R) == occupied, "the centres")
        eventually(lambda: cubes.voxels(R) == occupied, "the cubes")
        eventually(lambda: projected.message and self.is_projection(projected.message, tree), "the map from above")
        frames = {m.message.header.frame_id for m in (full, binary, centres, projected)} | cubes.frames
        self.assertEqual(frames, {"map"})
        self.assertTrue(node.call("reset").success)
        eventually(lambda: not full.message.data and not binary.message.data, "trees without nodes")
        eventually(lambda: centres.message.width == 0 and not cubes.voxels(R), "no voxels are shown")
        eventually(lambda: not Grid(projected.message).known(), "nothing is known from above")

    def is_projection(self, message, tree):
        """Whether each cell is what the columns of the tree say between 0.3 m below and 0.2 m above 0."""
        grid = Grid(message)
        low, high = 32768 - 3, 32768 + 2  # keys of z
        columns = {(x, y): 0 for x, y, z in tree.voxels(False) if low <= z < high}
        columns.update({(x, y): 100 for x, y, z in tree.voxels(True) if low <= z < high})
        return grid.known() == {(x - 32768, y - 32768, value) for (x, y), value in columns.items()}

    def test_saved_and_loaded(self):
        robot, node = self.octomap()
        self.walk(robot, node)
        tree = self.tree(node)
        answer = node.call("save")
        self.assertTrue(answer.success, answer.message)
        folder = self.folder / node.namespace[1:]
        self.assertEqual({path.name for path in folder.iterdir()}, {"octomap.ot", "octomap.bt", "octomap.yaml"})
        self.assertEqual(Octree.of_file((folder / "octomap.ot").read_bytes()).leaves, tree.leaves)
        self.assertEqual(Octree.of_file((folder / "octomap.bt").read_bytes()).voxels(True), tree.voxels(True))
        self.assertIn("map_frame: map", (folder / "octomap.yaml").read_text())
        self.assertTrue(node.call("reset").success)
        self.assertFalse(self.tree(node).leaves)
        self.assertTrue(node.call("load").success)
        self.assertEqual(self.tree(node).leaves, tree.leaves)
        robot.send("drift_correction", messages.correction([(1000.0, (1.0, 0.0, 0.0))]))
        self.walk(robot, node, [(1010.0, (0.0, 0.0, 0.0))])
        self.assertGreater(self.tree(node).at(3.05, 0.05, 0.05), 0.0, "what comes is drawn with the correction")
        (folder / "octomap.ot").write_bytes((folder / "octomap.ot").read_bytes()[:-3])
        before = self.tree(node).leaves
        refused = node.call("load")
        self.assertFalse(refused.success)
        self.assertIn("octomap.ot", refused.message)
        self.assertEqual(self.tree(node).leaves, before)
        node.close()
        self.load_with_another_resolution(robot, node.namespace, tree)

    def load_with_another_resolution(self, robot, namespace, tree):
        """Only the .bt file is left, with voxels of half the size."""
        folder = self.folder / namespace[1:]
        (folder / "octomap.ot").unlink()
        for mode, loads in (("refuse", False), ("resample", True)):
            node = self.node(namespace, program="octomap", parameters={
                **OPTIONS, "resolution": 2 * R, "other_resolution": mode})
            (folder / "octomap.yaml").write_text((folder / "octomap.yaml").read_text())
            answer = node.call("load")
            self.assertEqual(answer.success, loads, answer.message)
            found = self.tree(node)
            self.assertEqual(bool(found.leaves), loads)
            if loads:
                self.assertEqual(found.voxels(True), {tuple(32768 + (k - 32768) // 2 for k in key)
                                                      for key in tree.voxels(True)})
            node.close()

    def test_bends_and_keeps_what_was_cleared(self):
        robot, node = self.octomap()
        self.walk(robot, node)
        straight = self.tree(node)
        self.clear(node, (1.9, -0.55, -1.0), (2.2, 0.55, 1.0))
        eventually(lambda: self.tree(node).at(2.05, 0.05, 0.05) < 0.0, "a hole in the wall")
        self.assertGreater(self.tree(node).at(2.05, 0.75, 0.05), 0.0, "beside the hole")
        holed = self.tree(node).voxels(True)
        robot.send("drift_correction", messages.correction([(1000.0, (1.0, 0.0, 0.0))]))
        ten = round(1.0 / R)
        eventually(lambda: self.tree(node).voxels(True) == {(x + ten, y, z) for x, y, z in holed},
                   "wall and hole have moved by a metre")
        self.assertLess(self.tree(node).at(2.05, 0.05, 0.05), 0.0, "where the wall was is free")
        robot.send("drift_correction", messages.correction([]))
        eventually(lambda: self.tree(node).voxels(True) == holed, "it is straight again, and has its hole")
        self.assertNotEqual(holed, straight.voxels(True))
        with self.assertRaises(rospy.ServiceException):
            self.clear(node, (1.0, 0.0, 0.0), (0.0, 1.0, 1.0))
        with self.assertRaises(rospy.ServiceException):
            self.clear(node, (0.0, 0.0, float("nan")), (1.0, 1.0, 1.0))
        self.assertEqual(self.tree(node).voxels(True), holed)

    def test_scans_and_filters(self):
        robot, node = self.octomap(pointcloud_frame="base_link", pointcloud_max_z=0.3, filter_speckles=True)
        cubes = self.closing(Cubes(f"{node.namespace}/occupied_cells_vis_array"))
        self.walk(robot, node, WAY[:1])
        tree = self.tree(node)
        self.assertGreater(tree.at(2.05, 0.05, 0.25), 0.0)
        self.assertIsNone(tree.at(2.05, 0.05, 0.35), "above what may enter")
        alone = (1.05, 1.05, 0.05)
        robot.stand(1001.0, WAY[0][1])
        robot.send("cloud_in", cloud(1001.0, WAY[0][1], [alone]))
        node.wait_for("clouds", used=2)
        occupied = self.tree(node).voxels(True)
        speckle = tuple(int(p / R) + 32768 for p in alone)
        self.assertIn(speckle, occupied)
        eventually(lambda: cubes.voxels(R) == occupied - {speckle}, "the speckle is not shown")
        node.call("reset")
        robot.stand(1002.0, (0.0, 0.0, 0.0))
        robot.send("scan", messages.scan(1002.0, "laser", Room().scan((0.0, 0.0, 0.0))))
        node.wait_for("scans", used=1)
        self.assertGreater(self.tree(node).at(2.05, 0.05, 0.05), 0.0, "the laser's wall")
        self.assertLess(self.tree(node).at(1.05, 0.05, 0.05), 0.0)

    def test_live_equals_offline(self):
        bag = self.folder / "hall.bag"
        with rosbag.Bag(str(bag), "w") as writer:
            writer.write("/tf_static", mounts(), messages.time(999.7))
            for i in range(40):
                stamp = 999.8 + 0.05 * i
                writer.write("/tf", messages.transforms(messages.transform(
                    stamp, "odom", "base_link", (0.02 * i, 0.01 * i, 0.03 * i))), messages.time(stamp))
            for i in range(8):
                stamp = 1000.03 + 0.1 * i
                writer.write("/cloud_in", cloud(stamp, (0.0, 0.0, 0.1 * i)), messages.time(stamp))
        options = {"resolution": R, "filter_ground": True, "thin_points": True}
        (self.folder / "config.yaml").write_text("octomap: {resolution: 0.1, filter_ground: true, thin_points: true}")
        subprocess.run([executable("bag_to_map"), "--config", str(self.folder / "config.yaml"), "--mappers", "octomap",
                        "--out", str(self.folder / "maps"), str(bag)], check=True, stderr=subprocess.DEVNULL)
        node = self.node(program="octomap", parameters=options)
        subprocess.run(bags.play_command(bag, node.namespace, rate=2), stdin=subprocess.DEVNULL,
                       stdout=subprocess.DEVNULL, check=True)
        node.wait_for("clouds", received=8, waiting=0)
        self.assertTrue(node.call("save").success)
        for name in ("octomap.ot", "octomap.bt", "octomap.yaml"):
            self.assertEqual((self.folder / node.namespace[1:] / name).read_bytes(),
                             (self.folder / "maps" / name).read_bytes(), name)
        self.assertGreater(min(png_size((self.folder / "maps/octomap.png").read_bytes())), 100)


if __name__ == "__main__":
    case.run("octomap_maps", OctomapMaps)
