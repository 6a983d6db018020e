#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Parameters: what is wrong ends the node with every fault named; frames, topics and namespaces are the user's."""
import rospy

from portolan_testing import case, messages
from portolan_testing.grid import Grid
from portolan_testing.node import Node
from portolan_testing.room import Room
from portolan_testing.waiting import eventually

HERE = (0.0, 0.0, 0.0)
STAMPS = [1000.0 + 0.1 * i for i in range(4)]


class GridParameters(case.NodeCase):
    def errors_of(self, **parameters):
        """What a node says that does not start."""
        node = self.closing(Node(self.new_namespace(), parameters=parameters, until_ready=False))
        self.assertGreater(node.exit_code(), 0)
        return node.errors()

    def test_all_faults_at_once(self):
        errors = self.errors_of(resolution=-0.1, resolutoin=0.1, tf_wait="long", on_time_jump="forget", queue_size=0,
                                laser={"p_free": 2.0, "beem_model": "ray"}, sonar_topics=7, redraw_share=1.0)
        self.assert_in_words(["resolution", "resolutoin", "tf_wait", "on_time_jump", "queue_size", "laser/p_free",
                              "laser/beem_model", "sonar_topics", "redraw_share"], errors)

    def test_odometry_by_topic(self):
        robot, node = self.pair(parameters={"odom_topic": "odom"})
        robot.wait_until_heard(("odom",))
        for i, frames in enumerate((("odom", "base_link"), ("", ""), ("/odom", "/base_link"))):
            stamp, pose = STAMPS[i], (1.0, 0.0, 0.1 * i)
            robot.send("odom", messages.odometry(stamp, *frames, pose))
            scan = messages.scan(stamp, "laser", Room(half_side=3.05).scan(pose))
            robot.send("scan", scan)
        node.wait_for("scans", used=3)
        self.assertGreater(node.map().at(3.05, 0.05), 65)

    def test_renamed_topics(self):
        topics = {"scan_topics": ["front", "rear"], "sonar_topics": [], "cloud_in_topics": ["/far/cloud"]}
        robot = self.robot()
        names = (f"{self.namespace}/front", f"{self.namespace}/rear", f"{self.namespace}/scan")
        publishers = [rospy.Publisher(name, type(messages.scan(1.0, "laser", [])), queue_size=10) for name in names]
        for publisher in publishers:
            self.addCleanup(publisher.unregister)
        node = self.node(parameters=topics)
        robot.wait_until_heard(("tf", "tf_static"))
        eventually(lambda: all(p.get_num_connections() > 0 for p in publishers[:2]), "the node listens")
        robot.stand(STAMPS[0], HERE)
        for i, publisher in enumerate(publishers):
            robot.stand(STAMPS[i], HERE)
            publisher.publish(messages.scan(STAMPS[i], "laser", Room().scan(HERE)))
        node.wait_for("scans", used=2)
        self.assertEqual(publishers[2].get_num_connections(), 0, "nobody listens to the old name")

    def test_frames(self):
        names = {"map_frame": "world", "odom_frame": "bot/odom", "base_frame": "bot/base_link"}
        robot = self.robot(prefix="bot/")
        node = self.node(parameters=names)
        robot.wait_until_heard()
        listener = self.listener()
        robot.look_around(Room(), STAMPS)
        node.wait_for("scans", used=len(STAMPS))
        eventually(lambda: listener.at(2.05, 0.05) > 65, "the room is mapped")
        self.assertEqual(listener.wholes[-1].header.frame_id, "world")
        self.assertEqual(Grid(listener.wholes[-1]).frame, "world")

    def test_two_robots_share_a_tf(self):
        shared = f"{self.namespace}/tf", f"{self.namespace}/tf_static"
        remap = {"/tf": shared[0], "/tf_static": shared[1]}
        robots, nodes = [], []
        for number, namespace in enumerate((self.new_namespace(), self.new_namespace())):
            prefix = f"r{number}/"
            robots.append(self.robot(namespace, prefix=prefix, tf=shared[0], tf_static=shared[1]))
            nodes.append(self.node(namespace, remap=remap, parameters={"odom_frame": prefix + "odom",
                                                                       "base_frame": prefix + "base_link"}))
        for robot in robots:
            robot.wait_until_heard(("tf", "tf_static"), listeners=2)
            robot.wait_until_heard(("scan", "sonar"))
        for robot in robots:
            robot.mount()  # again: on a shared topic only the last mounts are latched
        for robot, half_side in zip(robots, (2.05, 1.05)):
            robot.look_around(Room(half_side), STAMPS)
        for robot, node in zip(robots, nodes):
            node.wait_for("scans", used=len(STAMPS), received=len(STAMPS))
            node.wait_for("echoes", used=robot.sent["sonar"], received=robot.sent["sonar"])
        self.assertGreater(nodes[0].map().at(2.05, 0.05), 65)
        self.assertEqual(nodes[1].map().at(2.05, 0.05), -1)
        self.assertGreater(nodes[1].map().at(1.05, 0.05), 65)
        self.assertLess(nodes[0].map().at(1.05, 0.05), 35)
        self.assertTrue(nodes[0].call("reset").success)
        self.assertEqual(nodes[0].map().known(), set())
        self.assertGreater(nodes[1].map().at(1.05, 0.05), 65)


if __name__ == "__main__":
    case.run("grid_parameters", GridParameters)
