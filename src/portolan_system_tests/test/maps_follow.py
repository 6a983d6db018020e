#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A simulated robot with drifting odometry, all five nodes: every map follows the pose graph, live and from a bag."""
import statistics
import subprocess

import rosbag
import rospy
from geometry_msgs.msg import Pose
from octomap_msgs.srv import GetOctomap
from portolan_msgs.msg import BeaconMap, LandmarkMap
from portolan_msgs.srv import AddArc, ListArcs, SetArcs

from portolan_testing import case, loop_drive
from portolan_testing.block import block, occupied_places, off_the_walls
from portolan_testing.grid import files_of
from portolan_testing.node import Node, executable
from portolan_testing.octree import MIDDLE, Latest, Octree
from portolan_testing.waiting import eventually

KINDS = {"occupancy_grid": "map", "octomap": "octomap", "landmarks": "landmarks", "beacons": "beacons"}
TOPICS = {"scan": ("occupancy_grid", "scans"), "cloud_in": ("octomap", "clouds"),
          "landmark_sightings": ("landmarks", "sightings"), "beacon_ranges": ("beacons", "rangings")}
ACCEPTED = 0
SURE = [1e4 if i % 7 == 0 else 0.0 for i in range(36)]
# So far off, at most, when the pose graph has spoken: mean of walls, median of marks [m].
GOOD = {"grid": 0.2, "octree": 0.2, "landmarks": 0.25, "beacons": 0.4}


def median_error(marks, truth):
    """Of pairs (id, point), those that the map holds; infinite where one is missing."""
    found = {id_: (p.x, p.y) for id_, p in marks}
    if set(truth) - set(found):
        return float("inf")
    return statistics.median(((found[i][0] - x) ** 2 + (found[i][1] - y) ** 2) ** 0.5 for i, (x, y) in truth.items())


class MapsFollow(case.NodeCase):
    def start(self):
        self.world, self.robot_file = loop_drive.write_files(self.folder)
        self.nodes = {name: self.node(program=name, parameters={**options, "publish_interval": 0.1})
                      for name, options in loop_drive.MAPPERS.items()}
        self.graph = self.nodes["pose_graph"]
        self.topics = {name: self.closing(Latest(f"{self.namespace}/{name}", type_))
                       for name, type_ in (("landmarks", LandmarkMap), ("beacons", BeaconMap))}

    def tool(self, package, name, *arguments):
        done = subprocess.run([executable(name, package), *map(str, arguments)], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, universal_newlines=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)

    def record(self):
        """The same drive as a bag; gives how many messages each topic has."""
        self.bag = self.folder / "drive.bag"
        self.tool("portolan_sim", "record_drive", self.world, self.robot_file, self.bag)
        with rosbag.Bag(str(self.bag)) as bag:
            return {topic: bag.get_message_count("/" + topic) for topic in TOPICS}

    def offline(self, name, mappers):
        self.tool("portolan_ros", "bag_to_map", "--config", self.robot_file, "--out", self.folder / name, "--mappers",
                  ",".join(mappers), self.bag)
        return {kind: {file: content for file, content in files_of(self.folder / name, begins).items()
                       if not file.endswith(".png")} for kind, begins in KINDS.items()}

    def drive(self, counts):
        self.closing(Node(self.namespace, program="robot_sim", until_ready=False, parameters={
            **loop_drive.robot(), "world_file": str(self.world), "real_time_factor": 8.0,
            "wait_for_subscribers": [*TOPICS, "scan"]}))  # the grid and the pose graph
        heard = [(self.graph, "scans", counts["scan"])]
        heard += [(self.nodes[node], noun, counts[topic]) for topic, (node, noun) in TOPICS.items()]
        for node, noun, count in heard:
            eventually(lambda: node.tally(noun).received == count and node.tally(noun).waiting == 0,
                       lambda: f"{count} {noun}: {node.tally(noun)}", seconds=150.0)
            self.assertEqual(set(node.tally(noun).dropped) - {"thinned"}, set(), node.tally(noun))

    def all_saved(self):
        """What all mappers save."""
        saved = {}
        for name, begins in KINDS.items():
            answer = self.nodes[name].call("save")
            self.assertTrue(answer.success, answer.message)
            saved[name] = files_of(self.folder / self.namespace[1:], begins)
        return saved

    def eventually_saved(self, expected, what):
        """Until all maps save just these bytes."""
        differing = []

        def are_equal():
            saved = self.all_saved()
            differing[:] = [file for kind, files in saved.items() for file in files
                            if files[file] != expected[kind].get(file)]
            return saved.keys() == expected.keys() and not differing
        eventually(are_equal, lambda: f"{what}; these differ: {differing}")

    def errors(self):
        """Of each map as it is on its topic or service [m]."""
        room = block()
        tree = Octree.of(rospy.ServiceProxy(f"{self.namespace}/octomap_binary", GetOctomap)().map)
        side = tree.resolution
        voxels = [((x - MIDDLE + 0.5) * side, (y - MIDDLE + 0.5) * side)
                  for x, y, z in tree.voxels(occupied=True) if 0.3 < (z - MIDDLE) * side < 1.2]
        landmarks = self.topics["landmarks"].message.landmarks
        beacons = self.topics["beacons"].message.beacons
        return {"grid": off_the_walls(occupied_places(self.nodes["occupancy_grid"].map()), room),
                "octree": off_the_walls(sorted(set(voxels)), room),
                "landmarks": median_error([(m.id, m.position) for m in landmarks], loop_drive.LANDMARKS),
                "beacons": median_error([(b.id, b.modes[0].position) for b in beacons], loop_drive.BEACONS)}

    def eventually_errors(self, condition, what):
        """Until the errors of all maps fulfil condition(kind, error)."""
        last = {}

        def hold():
            last.update(self.errors())
            return all(condition(kind, error) for kind, error in last.items())
        eventually(hold, lambda: f"{what}; they are {last}")
        return dict(last)

    def service(self, name, type_, *arguments):
        return rospy.ServiceProxy(f"{self.graph.name}/{name}", type_)(*arguments)

    def test_a_session(self):
        self.start()
        counts = self.record()
        before = self.offline("before", KINDS)
        after = self.offline("after", [*KINDS, "pose_graph"])
        self.drive(counts)
        good = self.eventually_errors(lambda kind, error: error < GOOD[kind], "all maps are good")
        self.eventually_saved(after, "the maps are those of the bag, byte for byte")
        for name, files in before.items():
            self.assertNotEqual(files, after[name], f"{name} of the bag bends")
        self.check_loops_out_and_in(good, after)
        self.check_a_false_loop_leaves_no_trace(after)
        self.check_a_graph_that_dies(after)

    def check_loops_out_and_in(self, good, after):
        loops = [arc.index for arc in self.service("list_arcs", ListArcs, False).arcs if arc.state == ACCEPTED]
        self.assertGreater(len(loops), 2)
        self.assertTrue(self.service("disable_arcs", SetArcs, loops).success)
        self.eventually_errors(lambda kind, error: error > 2.0 * good[kind], "without loops all maps are worse")
        self.assertTrue(self.service("enable_arcs", SetArcs, loops).success)
        self.eventually_saved(after, "all maps are as they were")

    def check_a_false_loop_leaves_no_trace(self, after):
        pose = Pose()
        pose.orientation.w = 1.0
        answer = self.service("add_arc", AddArc, 3, 60, pose, SURE, False)
        self.assertEqual((answer.success, answer.message), (False, "inconsistent"))
        answer = self.service("add_arc", AddArc, 3, 60, pose, SURE, True)
        self.assertTrue(answer.success, answer.message)
        eventually(lambda: all(files != after[name] for name, files in self.all_saved().items()), "every map is bent wrongly")
        self.assertTrue(self.service("disable_arcs", SetArcs, [answer.arc]).success)
        self.eventually_saved(after, "every map is as before, byte for byte")

    def check_a_graph_that_dies(self, after):
        """The maps keep what they know of the drift; a new graph that loads the old one goes on from there."""
        self.assertTrue(self.graph.call("save").success)
        self.graph.kill()
        self.graph = self.node(program="pose_graph", parameters=loop_drive.MAPPERS["pose_graph"])
        self.assertEqual(self.all_saved(), after)
        answer = self.graph.call("load")
        self.assertTrue(answer.success, answer.message)
        eventually(lambda: int(self.graph.values().get("loops accepted", 0)) > 2, "the loops are back")
        self.eventually_errors(lambda kind, error: error < GOOD[kind], "all maps are good")


if __name__ == "__main__":
    case.run("maps_follow", MapsFollow)
