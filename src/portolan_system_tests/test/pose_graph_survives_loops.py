#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Time runs back while a pose graph bends the maps: a bag that loops, and a map that is to be kept."""
import subprocess

import rospy
from portolan_msgs.msg import DriftCorrection
from portolan_msgs.srv import ListArcs

from portolan_testing import bags, case, loop_drive
from portolan_testing.block import block, occupied_places, off_the_walls
from portolan_testing.node import executable
from portolan_testing.octree import Latest
from portolan_testing.waiting import eventually

GRAPH, GRID = loop_drive.MAPPERS["pose_graph"], loop_drive.MAPPERS["occupancy_grid"]
ROUNDS = 2
GOOD = 0.2  # mean distance of walls from the true ones [m]
ACCEPTED = 0


class PoseGraphSurvivesLoops(case.NodeCase):
    def drive(self):
        """The bag of the drive round the block, with scans alone."""
        path = self.folder / "drive.bag"
        world, robot = loop_drive.write_files(self.folder, sensors=("lasers",))
        subprocess.run([executable("record_drive", "portolan_sim"), str(world), str(robot), str(path)], check=True,
                       stdout=subprocess.DEVNULL)
        return path

    def pair_of_nodes(self, **grid):
        self.graph = self.node(program="pose_graph", parameters=GRAPH)
        self.grid = self.node(parameters={**GRID, "sonar_topics": [], **grid})
        for topic in ("odom", "ground_truth"):  # the player waits until somebody listens to all that it plays
            self.addCleanup(rospy.Subscriber(f"{self.namespace}/{topic}", rospy.AnyMsg).unregister)
        self.correction = self.closing(Latest(f"{self.namespace}/drift_correction", DriftCorrection))

    def play(self, *arguments):
        player = subprocess.Popen(bags.play_command(self.drive(), self.namespace, rate=8) + list(arguments),
                                  stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        self.addCleanup(player.wait)
        self.addCleanup(player.terminate)
        return player

    def jumps(self):
        return [int(node.values().get("times the clock ran back", 0)) for node in (self.graph, self.grid)]

    def loops(self):
        arcs = rospy.ServiceProxy(f"{self.graph.name}/list_arcs", ListArcs)(False).arcs
        return [arc for arc in arcs if arc.state == ACCEPTED]

    def walls(self):
        return off_the_walls(occupied_places(self.grid.map()), block())

    def test_a_bag_that_loops(self):
        self.pair_of_nodes()
        self.play("--loop")
        for jumps in range(ROUNDS):
            eventually(lambda: len(self.loops()) > 2, f"round {jumps}: loops are found", seconds=120.0)
            eventually(lambda: occupied_places(self.grid.map()) and self.walls() < GOOD, lambda: f"walls are {self.walls()}")
            eventually(lambda: min(self.jumps()) > jumps, "both notice that time ran back", seconds=120.0)
            eventually(lambda: self.correction.message.stamps == [] or
                       self.correction.message.stamps[-1].to_sec() < loop_drive.BEGIN + 30.0, "the correction is a new one")

    def test_a_kept_map_stays_as_it_was_bent(self):
        self.pair_of_nodes(on_time_jump="keep")
        self.assertEqual(self.play().wait(), 0)
        eventually(lambda: len(self.loops()) > 2, "loops are found", seconds=120.0)
        eventually(lambda: self.walls() < GOOD, lambda: f"walls are {self.walls()}")
        last = eventually(lambda: self.correction.message.stamps, "a correction comes")[-1].to_sec()
        kept = self.saved(self.grid)
        robot = self.robot()
        robot.wait_until_heard(("tf",), listeners=2)
        robot.tick(loop_drive.BEGIN - 5.0)
        eventually(lambda: self.jumps() == [1, 1], "both notice that time ran back")
        eventually(lambda: not self.correction.message.stamps, f"the graph of {last} s is forgotten")
        self.assertEqual(self.saved(self.grid), kept)


if __name__ == "__main__":
    case.run("pose_graph_survives_loops", PoseGraphSurvivesLoops)
