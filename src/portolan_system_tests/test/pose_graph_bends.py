#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A robot whose odometry turns too much drives round a block twice: the pose graph finds the loop, and the map bends."""
import contextlib
import fcntl
import math
import os
import threading

import rospy
from geometry_msgs.msg import Pose, PoseWithCovarianceStamped
from nav_msgs.msg import Path
from portolan_msgs.msg import DriftCorrection, GraphArc, PoseGraph
from portolan_msgs.srv import AddArc, ListArcs, SetArcs
from tf2_msgs.msg import TFMessage

from portolan_testing import case
from portolan_testing.block import block, occupied_places, off_the_walls
from portolan_testing.waiting import eventually

ACCEPTED, REJECTED = 0, 1
SIDE = 10.0     # of the square that the robot drives [m]
STEP = 0.25     # [m] between scans
DRIFT = 0.0015  # [rad] in each step
PARAMETERS = {"scans": {"enabled": False}}  # no matches of neighbours, so that all drift is left to the loops
SURE = [1e4 if i % 7 == 0 else 0.0 for i in range(36)]


def on_the_round(way):
    """Pose (x, y, yaw) after so much way [m] along the corridors."""
    side, along = divmod(way % (4.0 * SIDE), SIDE)
    yaw = side * math.pi / 2.0
    x, y = along - SIDE / 2.0, -SIDE / 2.0
    return (x * math.cos(yaw) - y * math.sin(yaw), x * math.sin(yaw) + y * math.cos(yaw), yaw)


def then(a, b):
    """Pose b, given in the frame of pose a, in the frame of a's parent."""
    c, s = math.cos(a[2]), math.sin(a[2])
    return (a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], a[2] + b[2])


def between(a, b):
    """Pose b in the frame of pose a."""
    c, s, dx, dy = math.cos(a[2]), math.sin(a[2]), b[0] - a[0], b[1] - a[1]
    return (c * dx + s * dy, -s * dx + c * dy, b[2] - a[2])


def by_hand(frame, pose, variance):
    """A pose as rviz's "2D Pose Estimate" sends it."""
    message = PoseWithCovarianceStamped()
    message.header.frame_id = frame
    message.pose.pose.position.x, message.pose.pose.position.y = pose[:2]
    message.pose.pose.orientation.z, message.pose.pose.orientation.w = math.sin(pose[2] / 2.0), math.cos(pose[2] / 2.0)
    for i, value in ((0, variance), (7, variance), (35, 0.07)):
        message.pose.covariance[i] = value
    return message


@contextlib.contextmanager
def open_folder(path):
    """A descriptor of it, closed in the end; locks go with it."""
    descriptor = os.open(path, os.O_RDONLY)
    try:
        yield descriptor
    finally:
        os.close(descriptor)


def newest(tfs, child):
    """Stamp [s] of the last transform of this frame."""
    return max(t.header.stamp.to_sec() for message in list(tfs) for t in message.transforms if t.child_frame_id == child)


def thickness(grid, room):
    """Mean distance of occupied cells from the nearest wall [m]."""
    return off_the_walls(occupied_places(grid), room)


class PoseGraphBends(case.NodeCase):
    steps, odom = 0, on_the_round(0.0)  # the first pose of odometry is the true one

    def drive(self, robot, graph, way):
        """Drives so far, by the way from the start."""
        room, last = block(), on_the_round(max(self.steps - 1, 0) * STEP)
        for i in range(self.steps, int(way / STEP)):
            now = on_the_round(i * STEP)
            self.odom, last = then(self.odom, then(between(last, now), (0.0, 0.0, DRIFT))), now
            robot.look(room, 1000.0 + 0.5 * i, now, seen_as=self.odom)
            self.steps = i + 1
            if i % 40 == 39:
                graph.wait_for("scans", received=robot.sent["scan"], waiting=0)

    def service(self, node, name, type_, **request):
        return rospy.ServiceProxy(f"{node.name}/{name}", type_)(**request)

    def loops(self, node, state=ACCEPTED):
        arcs = self.service(node, "list_arcs", ListArcs, all=False).arcs
        return [arc for arc in arcs if arc.state == state]

    def latest(self, topic, type_):
        """A list that the topic's messages are appended to."""
        messages = []
        subscriber = rospy.Subscriber(f"{self.namespace}/{topic}", type_, messages.append)
        self.addCleanup(subscriber.unregister)
        return messages

    def settled_map(self, grid, corrections, count):
        """The grid's files once so many corrections have come and the map is redrawn."""
        eventually(lambda: len(corrections) >= count, "a correction comes")
        eventually(lambda: grid.values().get("redrawn") == "1", "the map is redrawn")
        return self.saved(grid)

    def test_a_session(self):
        graph = self.node(program="pose_graph", parameters=PARAMETERS)
        robot, grid = self.pair()
        robot.wait_until_heard(("tf", "tf_static", "scan"), listeners=2)
        corrections = self.latest("drift_correction", DriftCorrection)
        graphs, paths, tfs = self.latest("pose_graph", PoseGraph), self.latest("path", Path), self.latest("tf", TFMessage)
        self.drive(robot, graph, 66.0)
        grid.wait_for("scans", received=robot.sent["scan"], waiting=0)

        loops = self.loops(graph)
        self.assertGreater(len(loops), 2, graph.values())
        eventually(lambda: corrections and graphs and paths, "correction, graph and path come")
        eventually(lambda: any(t.child_frame_id == "odom" and t.header.frame_id == "map"
                               for message in tfs for t in message.transforms), "the map frame is on tf")
        eventually(lambda: len(paths[-1].poses) == len(graphs[-1].poses) > 80, "the path is that of the keyframes")
        self.check_tf_goes_on_while_the_node_is_busy(graph, tfs)
        self.check_the_map_bends(graph, grid, corrections, loops)
        self.check_a_false_loop_leaves_no_trace(graph, grid, corrections)
        self.check_a_graph_that_goes_on(graph, robot)

    def test_who_listens_to_one_topic_in_place_of_another_gets_it(self):
        self.node(program="pose_graph", parameters={"publish_interval": 2.0})
        paths = []
        subscriber = rospy.Subscriber(f"{self.namespace}/path", Path, paths.append)
        eventually(lambda: paths, "the empty graph's path comes")
        subscriber.unregister()
        graphs = self.latest("pose_graph", PoseGraph)
        eventually(lambda: graphs, "the empty graph comes")

    def check_tf_goes_on_while_the_node_is_busy(self, graph, tfs):
        """Held up by somebody else's lock on its folder, the node still says where the map is."""
        directory = self.folder / self.namespace[1:]
        directory.mkdir(exist_ok=True)
        saving = threading.Thread(target=graph.call, args=("save",))
        with open_folder(directory) as folder:
            fcntl.flock(folder, fcntl.LOCK_EX)
            saving.start()
            eventually(lambda: newest(tfs, "odom") > graph.clock() + 1.0, "tf is newer than all else that the node says")
            self.assertTrue(saving.is_alive())
        saving.join()

    def check_the_map_bends(self, graph, grid, corrections, loops):
        eventually(lambda: grid.values().get("redrawn") == "1", "the map is redrawn")
        bent = thickness(grid.map(), block())
        count = len(corrections)
        arcs = [arc.index for arc in loops]
        self.assertTrue(self.service(graph, "disable_arcs", SetArcs, arcs=arcs).success)
        self.settled_map(grid, corrections, count + 1)
        eventually(lambda: thickness(grid.map(), block()) > 1.5 * bent, lambda: f"without loops walls are thick: {bent}")
        count = len(corrections)
        self.assertTrue(self.service(graph, "enable_arcs", SetArcs, arcs=arcs).success)
        self.settled_map(grid, corrections, count + 1)
        eventually(lambda: abs(thickness(grid.map(), block()) - bent) < 1e-9, "the map is as it was")

    def check_a_false_loop_leaves_no_trace(self, graph, grid, corrections):
        before = self.saved(grid)
        pose = Pose()
        pose.orientation.w = 1.0
        answer = rospy.ServiceProxy(f"{graph.name}/add_arc", AddArc)(3, 60, pose, SURE, False)
        self.assertFalse(answer.success)
        self.assertEqual(answer.message, "inconsistent")
        count = len(corrections)
        answer = rospy.ServiceProxy(f"{graph.name}/add_arc", AddArc)(3, 60, pose, SURE, True)
        self.assertTrue(answer.success, answer.message)
        self.assertNotEqual(self.settled_map(grid, corrections, count + 1), before)
        count = len(corrections)
        self.assertTrue(self.service(graph, "disable_arcs", SetArcs, arcs=[answer.arc]).success)
        eventually(lambda: self.settled_map(grid, corrections, count + 1) == before, "the map's files are as before")

    def check_a_graph_that_goes_on(self, graph, robot):
        """Killed, started again and loaded, it knows its places by what it saw there before."""
        self.files = "pose_graph"
        files = self.saved(graph)
        self.assertEqual(set(files), {"pose_graph.g2o", "pose_graph.stamps", "pose_graph.scans", "pose_graph.tum"})
        keyframes = len(files["pose_graph.stamps"].splitlines())
        graph.kill()
        graph = self.node(program="pose_graph", parameters=PARAMETERS)
        self.check_a_broken_file(graph, files["pose_graph.scans"])
        answer = graph.call("load")
        self.assertTrue(answer.success, answer.message)
        eventually(lambda: graph.values().get("keyframes") == str(keyframes), "the graph is back")
        again = self.saved(graph)
        for kind in ("stamps", "scans"):
            self.assertEqual(again[f"pose_graph.{kind}"], files[f"pose_graph.{kind}"])
        robot.close()
        robot = self.robot()  # whose listeners are not the dead one's
        robot.wait_until_heard(("tf", "tf_static", "scan"), listeners=2)
        self.drive(robot, graph, 90.0)
        bridges = [arc for arc in self.loops(graph) if arc.from_ < keyframes <= arc.to]
        self.assertGreater(len(bridges), 2, graph.values())
        self.check_a_robot_that_is_carried(graph, robot)

    def check_a_robot_that_is_carried(self, graph, robot):
        """Half a round further on, without odometry's knowing; somebody says where it is."""
        publisher = rospy.Publisher(f"{self.namespace}/initialpose", PoseWithCovarianceStamped, queue_size=10)
        eventually(lambda: publisher.get_num_connections() > 0, "the graph listens")
        self.steps += int(2.0 * SIDE / STEP)
        now = on_the_round(self.steps * STEP)
        keyframes = int(graph.values()["keyframes"])
        for frame, variance, fate in (("odom", 0.25, "other_frame"), ("map", math.nan, "malformed"), ("map", 0.25, "used")):
            publisher.publish(by_hand(frame, (now[0] + 0.3, now[1] - 0.2, now[2] + 0.1), variance))
            eventually(lambda: graph.values().get(f"initial poses: {fate}") == "1", f"a pose by hand is {fate}")
        self.drive(robot, graph, (self.steps + 3) * STEP)  # a lone stamp would be taken for a leap
        graph.wait_for("scans", received=robot.sent["scan"], waiting=0)
        eventually(lambda: graph.values().get("place known") != "yes", "a loop has to confirm it")
        given = [arc for arc in self.loops(graph) if arc.kind == GraphArc.GIVEN]
        self.assertEqual([(arc.from_, arc.to) for arc in given], [(keyframes - 1, keyframes)])
        stamp, x, y = (float(word) for word in self.saved(graph)["pose_graph.tum"].splitlines()[-1].split()[:3])
        self.assertLess(math.hypot(x - now[0], y - now[1]), 1.5, stamp)

    def check_a_broken_file(self, graph, scans):
        """Nothing is loaded then, and the answer says why."""
        path = self.folder / graph.namespace[1:] / "pose_graph.scans"
        path.write_bytes(scans[:-1])
        answer = graph.call("load")
        self.assertFalse(answer.success)
        self.assertIn("pose_graph.scans: scan", answer.message)
        self.assertIn("is cut off", answer.message)
        path.write_bytes(scans)
        self.assertEqual(self.service(graph, "list_arcs", ListArcs, all=True).arcs, [])


if __name__ == "__main__":
    case.run("pose_graph_bends", PoseGraphBends)
