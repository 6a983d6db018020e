#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The beacons node maps from ranges, bends with corrections, forgets, saves and loads, and bears with rubbish."""
import math
import subprocess

import rosbag
import rospy
import yaml
from visualization_msgs.msg import MarkerArray

from portolan_testing import bags, beacons, case, messages
from portolan_testing.grid import files_of, png_size
from portolan_testing.node import executable
from portolan_testing.robot import heard_by, mounts
from portolan_testing.waiting import eventually

TRUTH = {3: (3.0, 1.0), 8: (-2.5, 3.5), 4000000000: (0.5, -3.0)}
STEPS = range(40)
SHIFT = (1.0, -0.5, 0.7)  # of odometry in the map: x, y [m], yaw [rad]
KNOWN = {"drift": 0.0, "calibration": {"scale_stddev": 0.0, "bias_stddev": 0.0, "turn_stddev": 0.0}}  # poses and device


def shifted(point):
    c, s = math.cos(SHIFT[2]), math.sin(SHIFT[2])
    return (SHIFT[0] + c * point[0] - s * point[1], SHIFT[1] + s * point[0] + c * point[1])


class BeaconsMap(beacons.BeaconCase):
    def mapped(self, namespace=None, **more):
        robot, node = self.pair(namespace, **more)
        beacons.drive(robot, TRUTH, STEPS)
        node.wait_for("rangings", used=len(STEPS))
        return robot, node

    def assert_at(self, listener, places, what):
        """Each beacon ends where it is, and says so."""
        eventually(lambda: all(listener.beacon(id_) and listener.beacon(id_).error(place) < 0.15
                               for id_, place in places.items()), what)
        for id_, place in places.items():
            beacon = listener.beacon(id_)
            self.assertFalse(beacon.message.ambiguous, id_)
            self.assertLess(beacon.sigmas(place), 3.0, id_)

    def test_beacons_are_where_they_are_seen_from_an_antenna_off_the_middle(self):
        _, node = self.mapped(parameters=KNOWN)
        listener = self.listener()
        self.assert_at(listener, TRUTH, "the map shows the beacons")
        for id_, place in TRUTH.items():
            self.assertLess(listener.beacon(id_).error(place), 0.03)
        self.assertEqual(listener.last.header.frame_id, "map")
        self.assertEqual([b.id for b in listener.last.beacons], sorted(TRUTH))
        self.assertEqual(listener.taken(), len(STEPS) * len(TRUTH))
        self.assertEqual(node.level(), 0, node.sentence())
        self.assertEqual(node.values()["ranges taken"], str(len(STEPS) * len(TRUTH)))

    def test_the_first_ranges_leave_a_ring_and_a_place_to_go(self):
        robot, node = self.pair()
        listener, markers = self.listener(), []
        subscriber = rospy.Subscriber(self.namespace + "/beacons_vis", MarkerArray, markers.append)
        self.addCleanup(subscriber.unregister)
        beacons.drive(robot, TRUTH, range(1))
        node.wait_for("rangings", used=1)
        ring = eventually(lambda: listener.beacon(3), "the ring comes")
        here = beacons.antenna_at(beacons.way(0))
        self.assertTrue(ring.message.ambiguous)
        self.assertGreater(len(ring.weights), 8)
        self.assertAlmostEqual(sum(ring.weights), 1.0, places=9)
        for mean in ring.means:
            self.assertAlmostEqual(math.dist(mean, here), math.dist(TRUTH[3], here), delta=0.2)
        drive = ring.message.drive
        self.assertAlmostEqual(math.hypot(drive.direction.x, drive.direction.y), 1.0, places=9)
        self.assertGreater(drive.expected_information, 0.1)
        eventually(lambda: markers, "markers come")
        spheres = [m for m in markers[-1].markers if m.ns == "modes"]
        self.assertEqual(len(spheres), sum(len(b.modes) for b in listener.last.beacons))
        self.assertEqual(len([m for m in markers[-1].markers if m.ns == "drives"]), len(TRUTH))

    def test_the_map_bends_with_the_correction_and_a_late_one_is_as_good_as_an_early_one(self):
        early, late = self.namespace, self.new_namespace()
        early_robot, late_robot = self.robot(early), self.robot(late)
        correction = messages.correction([(1000.0, SHIFT)])
        early_robot.send("drift_correction", correction)
        early_node, late_node = self.node(early), self.node(late)
        for robot, node in ((early_robot, early_node), (late_robot, late_node)):
            robot.wait_until_heard(heard_by("beacons"))
            beacons.drive(robot, TRUTH, STEPS)
            node.wait_for("rangings", used=len(STEPS))
        listener = self.listener(namespace=late)
        self.assert_at(listener, TRUTH, "the map is as odometry says")
        late_robot.send("drift_correction", correction)
        self.assert_at(listener, {id_: shifted(place) for id_, place in TRUTH.items()}, "the map has moved")
        eventually(lambda: self.saved(late_node) == self.saved(early_node), "both save the same bytes")

    def test_saves_forgets_and_loads(self):
        robot, node = self.mapped()
        listener = self.listener()
        first = self.saved(node)
        self.assertEqual(set(first), {"beacons.yaml"})
        head = yaml.safe_load(first["beacons.yaml"])
        self.assertEqual([b["id"] for b in head["beacons"]], sorted(TRUTH))
        self.assertEqual(set(head["beacons"][0]["modes"][0]), {"weight", "mean", "covariance"})
        self.assertTrue(node.call("reset").success)
        eventually(lambda: listener.taken() == 0 and not listener.last.beacons, "the map is empty")
        answer = node.call("load")
        self.assertTrue(answer.success, answer.message)
        self.assert_at(listener, TRUTH, "the map is back")
        self.assertEqual(self.saved(node), first)
        beacons.drive(robot, TRUTH, range(40, 50))
        node.wait_for("rangings", used=50)
        eventually(lambda: listener.taken() == 50 * len(TRUTH), "it maps on")
        self.assert_at(listener, TRUTH, "and is none the worse for it")

    def test_what_cannot_be_loaded_keeps_the_map(self):
        _, node = self.mapped()
        before = self.saved(node)
        path = self.folder / node.namespace[1:] / "beacons.yaml"
        good = before["beacons.yaml"].decode()
        for bad in ("", "[}", "version: 7\nbeacons: []\n", good.replace("version: 1", "version: 2"),
                    good.replace("ranges: 40", "ranges: many"), good.replace("mean: [", "mean: [.nan, "),
                    good.replace("weight: ", "weight: -"), good[:len(good) // 2]):
            path.write_text(bad)
            answer = node.call("load")
            self.assertFalse(answer.success, bad)
            self.assert_in_words(["beacons.yaml"], answer.message)
        self.assertEqual(self.saved(node), before)

    def test_ranges_that_are_no_distances(self):
        robot, node = self.pair()
        listener = self.listener()
        for step in range(3):
            robot.stand(beacons.stamp_of(step), beacons.way(step))
        bad = [math.nan, math.inf, -math.inf, 0.0, -1.0]
        robot.send("beacon_ranges", messages.ranges(1000.0, "antenna", [(1, value) for value in bad]))
        robot.send("beacon_ranges", messages.ranges(1000.1, "antenna", [(1, 2.0)], stddev=-1.0))
        node.wait_for("rangings", malformed=2, used=0)
        robot.send("beacon_ranges", messages.ranges(1000.2, "antenna", [(1, value) for value in bad + [3.0, 1e30]]))
        node.wait_for("rangings", used=1)
        eventually(lambda: listener.taken() == 1, "the one good range is taken")
        self.assertEqual(listener.last.ranges_malformed, len(bad))
        self.assertEqual(listener.last.ranges_too_long, 1)
        self.assertEqual([b.id for b in listener.last.beacons], [1])

    def test_thousands_of_beacons_are_too_many(self):
        robot, node = self.pair(parameters={"max_beacons": 20})
        listener = self.listener()
        robot.stand(1000.0, (0.0, 0.0, 0.0))
        robot.send("beacon_ranges", messages.ranges(1000.0, "antenna", [(i, 3.0) for i in range(5000)]))
        node.wait_for("rangings", used=1)
        eventually(lambda: listener.taken() == 20, "as many as may be")
        self.assertEqual(listener.last.ranges_refused, 4980)
        self.assertEqual(node.values()["ranges dropped: beacons too many"], "4980")

    def test_without_a_transform_nothing_is_mapped(self):
        robot, node = self.pair(parameters={"tf_wait": 0.2})
        robot.stand(1000.0, (0.0, 0.0, 0.0))
        robot.send("beacon_ranges", messages.ranges(1000.0, "antena", [(1, 3.0)]))
        node.wait_for("rangings", no_transform=1, used=0)
        self.assert_in_words(["0 of 1 rangings used", "antena"], node.sentence())
        self.assertEqual(node.level(), 1)

    def test_beacons_that_answer_in_messages_of_their_own_at_one_moment(self):
        robot, node = self.pair()
        for step in STEPS:
            robot.stand(beacons.stamp_of(step), beacons.way(step))
            for one in beacons.heard_from(TRUTH, beacons.way(step)):
                robot.send("beacon_ranges", messages.ranges(beacons.stamp_of(step), "antenna", [one]))
        node.wait_for("rangings", used=len(STEPS) * len(TRUTH))
        self.assert_at(self.listener(), TRUTH, "all are mapped")

    def test_a_bag_gives_the_same_bytes(self):
        bag = self.folder / "heard.bag"
        with rosbag.Bag(str(bag), "w") as out:
            out.write("/tf_static", mounts(), messages.time(999.0))
            for step in STEPS:
                stamp, pose = beacons.stamp_of(step), beacons.way(step)
                tf = messages.transforms(messages.transform(stamp, "odom", "base_link", pose))
                heard = messages.ranges(stamp, "antenna", beacons.heard_from(TRUTH, pose))
                out.write("/tf", tf, messages.time(stamp))
                out.write("/beacon_ranges", heard, messages.time(stamp))
        done = subprocess.run([executable("bag_to_map"), "--out", str(self.folder / "maps"), str(bag)],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        offline = files_of(self.folder / "maps", "")
        self.assertEqual(set(offline), {"beacons.yaml", "beacons.png", "trajectory.tum", "summary.yaml", "report.md"})
        self.assertEqual(max(png_size(offline["beacons.png"])), 1000)
        node = self.node()
        subprocess.run(bags.play_command(bag, node.namespace, rate=3), stdin=subprocess.DEVNULL,
                       stdout=subprocess.DEVNULL, check=True)
        node.wait_for("rangings", received=len(STEPS), waiting=0)
        self.assertEqual(self.saved(node)["beacons.yaml"], offline["beacons.yaml"])


if __name__ == "__main__":
    case.run("beacons_map", BeaconsMap)
