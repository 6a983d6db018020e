#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The landmarks node maps from ranges, bearings and images, bends, forgets, saves and loads, and bears with rubbish."""
import math
import subprocess

import numpy
import rosbag
import rospy
import yaml
from portolan_msgs.msg import Landmark, LandmarkMap
from visualization_msgs.msg import MarkerArray

from portolan_testing import case, messages
from portolan_testing.beacons import stamp_of, way
from portolan_testing.grid import files_of, png_size
from portolan_testing.landmarks import calibration, features, range_and_bearing, sighting, sightings
from portolan_testing.node import executable
from portolan_testing.robot import heard_by, mounts
from portolan_testing.waiting import eventually

TRUTH = {0: (3.0, 1.0), 5: (-2.5, 3.5), 2000000000: (0.5, -3.0)}
STEPS = range(30)
SHIFT = (1.0, -0.5, 0.7)  # of odometry in the map: x, y [m], yaw [rad]
NAN = float("nan")


def shifted(point):
    c, s = math.cos(SHIFT[2]), math.sin(SHIFT[2])
    return (SHIFT[0] + c * point[0] - s * point[1], SHIFT[1] + s * point[0] + c * point[1])


def seen_from(pose, with_ids=True, with_ranges=True):
    """What a planar sensor at pose (x, y, yaw) sees of the truth, all around."""
    seen = []
    for id_, place in TRUTH.items():
        range_, azimuth = range_and_bearing(place, pose)
        seen.append(sighting(id_ if with_ids else -1, range_ if with_ranges else NAN, azimuth))
    return seen


def drive(robot, steps=STEPS, **how):
    for step in steps:
        robot.stand(stamp_of(step), way(step))
        robot.send("landmark_sightings", sightings(stamp_of(step), "laser", seen_from(way(step), **how)))


class LandmarkListener:
    """The latched map as it comes."""

    def __init__(self, topic):
        self.last = None
        self._subscriber = rospy.Subscriber(topic, LandmarkMap, self._take)

    def _take(self, message):
        self.last = message

    def ids(self):
        return [landmark.id for landmark in self.last.landmarks] if self.last else None

    def places(self):
        return {m.id: (m.position.x, m.position.y) for m in self.last.landmarks} if self.last else {}

    def shows(self, truth):
        """Every landmark stands where it should, and there are no others."""
        places = list(self.places().values())
        return len(places) == len(truth) and all(
            any(math.dist(place, true) < 0.05 for place in places) for true in truth.values())

    def close(self):
        self._subscriber.unregister()


class LandmarksMap(case.NodeCase):
    files = "landmarks"

    def pair(self, namespace=None, program="landmarks", **more):
        return super().pair(namespace, program=program, **more)

    def listener(self, topic="landmarks", namespace=None):
        return self.closing(LandmarkListener(f"{namespace or self.namespace}/{topic}"))

    def test_maps_saves_forgets_and_loads(self):
        robot, node = self.pair()
        listener, markers = self.listener(), []
        subscriber = rospy.Subscriber(self.namespace + "/landmarks_vis", MarkerArray, markers.append)
        self.addCleanup(subscriber.unregister)
        drive(robot)
        node.wait_for("sightings", used=len(STEPS))
        eventually(lambda: listener.shows(TRUTH), "the map shows the landmarks")
        self.assertEqual(listener.ids(), sorted(TRUTH))
        self.assertEqual(listener.last.header.frame_id, "map")
        self.assertEqual(node.level(), 0, node.sentence())
        landmark = listener.last.landmarks[0]
        self.assertEqual((landmark.kind, landmark.sightings), (Landmark.POINT, len(STEPS)))
        covariance = numpy.array(landmark.covariance).reshape(3, 3)
        self.assertGreater(numpy.linalg.eigvalsh(covariance[:2, :2]).min(), 0.0)
        self.assertFalse(covariance[2].any())
        self.assertGreater(landmark.existence, 0.99)
        eventually(lambda: markers and len([m for m in markers[-1].markers if m.ns == "landmarks"]) == len(TRUTH),
                   "markers show them")

        first = self.saved(node)
        self.assertEqual(set(first), {"landmarks.yaml"})
        saved = yaml.safe_load(first["landmarks.yaml"])["landmarks"]
        self.assertEqual([m["id"] for m in saved], sorted(TRUTH))
        self.assertTrue({"mean", "covariance", "sightings", "kind"} <= set(saved[0]))
        self.assertTrue(node.call("reset").success)
        eventually(lambda: listener.ids() == [], "the map is empty")
        self.assertTrue(node.call("load").success)
        eventually(lambda: listener.shows(TRUTH), "the map is back")
        self.assertEqual(self.saved(node), first)
        path = self.folder / node.namespace[1:] / "landmarks.yaml"
        good = first["landmarks.yaml"].decode()
        for bad in ("", "[}", "version: 7\nlandmarks: []\n", good.replace("mean: [", "mean: [.nan, ")):
            path.write_text(bad)
            answer = node.call("load")
            self.assertFalse(answer.success, bad)
            self.assertIn("landmarks.yaml", answer.message)
        self.assertEqual(self.saved(node), first)

    def test_the_map_bends_with_the_correction(self):
        robot, node = self.pair()
        listener = self.listener()
        drive(robot)
        node.wait_for("sightings", used=len(STEPS))
        eventually(lambda: listener.shows(TRUTH), "the map is as odometry says")
        robot.send("drift_correction", messages.correction([(1000.0, SHIFT)]))
        eventually(lambda: listener.shows({id_: shifted(place) for id_, place in TRUTH.items()}), "it has moved")

    def test_without_identities_and_from_bearings_alone(self):
        robot, node = self.pair(parameters={"noise": {"azimuth_stddev": 0.005}})
        listener = self.listener()
        drive(robot, with_ids=False)
        node.wait_for("sightings", used=len(STEPS))
        eventually(lambda: listener.shows(TRUTH), "as many landmarks as there are")
        self.assertTrue(all(id_ < -1 for id_ in listener.ids()))
        self.assertTrue(node.call("reset").success)
        drive(robot, range(30, 75), with_ranges=False)
        node.wait_for("sightings", used=75)
        eventually(lambda: listener.shows(TRUTH), "bearings tell where they are")
        self.assertEqual({m.kind for m in listener.last.landmarks}, {Landmark.POINT})

    def test_images_need_to_know_their_camera(self):
        robot, node = self.pair()
        listener = self.listener()
        for step in range(4):
            robot.stand(stamp_of(step), (0.0, 0.0, 0.0))
        robot.send("image_features", features(stamp_of(0), [(1, 400.0, 300.0)]))
        node.wait_for("images", unusable=1)
        robot.send("camera_info", calibration(stamp_of(1), 0.0))
        node.wait_for("calibrations", malformed=1)
        robot.send("camera_info", calibration(1.0, 400.0))  # long before any transform
        node.wait_for("calibrations", used=1)
        robot.send("image_features", features(stamp_of(2), [(1, 400.0, 300.0), (2, NAN, 0.0)]))
        node.wait_for("images", used=1)
        landmark = eventually(lambda: listener.last and listener.last.landmarks and listener.last.landmarks[0],
                              "a ray is on the map")
        self.assertNotEqual(landmark.kind, Landmark.POINT)
        self.assertGreater(landmark.ray_mean.z, 0.0)

    def test_bears_with_rubbish(self):
        robot, node = self.pair()
        listener = self.listener()
        for step in range(6):
            robot.stand(stamp_of(step), (0.0, 0.0, 0.0))
        bad = [sighting(1, 2.0, NAN), sighting(1, -2.0, 0.1), sighting(1, 0.0, 0.1), sighting(1, math.inf, 0.1),
               sighting(1, 2.0, 0.1, range_stddev=-1.0), sighting(1, 2.0, 0.1, azimuth_stddev=NAN)]
        robot.send("landmark_sightings", sightings(stamp_of(0), "laser", bad))
        node.wait_for("sightings", malformed=1, used=0)
        robot.send("landmark_sightings", sightings(stamp_of(1), "laser", []))
        node.wait_for("sightings", used=1)
        good = sighting(1, 2.0, 0.0)
        robot.send("landmark_sightings", sightings(stamp_of(2), "laser", bad + [good, sighting(1, 5.0, 1.0)]))
        node.wait_for("sightings", used=2)
        robot.send("landmark_sightings", sightings(stamp_of(3), "laser", [sighting(1, 5.0, 1.0), good]))
        node.wait_for("sightings", used=3)
        eventually(lambda: listener.last and listener.last.sightings_taken == 2, "the good ones are taken")
        self.assertEqual(listener.last.sightings_repeated, 2)
        self.assertEqual(listener.last.sightings_malformed, len(bad))
        self.assertEqual(listener.ids(), [1])
        self.assertAlmostEqual(listener.places()[1][0], 2.0, places=6)

    def test_a_bag_gives_the_same_bytes(self):
        bag = self.folder / "seen.bag"
        with rosbag.Bag(str(bag), "w") as out:
            out.write("/tf_static", mounts(), messages.time(999.0))
            for step in STEPS:
                stamp, pose = stamp_of(step), way(step)
                tf = messages.transforms(messages.transform(stamp, "odom", "base_link", pose))
                out.write("/tf", tf, messages.time(stamp))
                out.write("/landmark_sightings", sightings(stamp, "laser", seen_from(pose)), messages.time(stamp))
        done = subprocess.run([executable("bag_to_map"), "--out", str(self.folder / "maps"), str(bag)],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        offline = files_of(self.folder / "maps", "")
        self.assertEqual(set(offline), {"landmarks.yaml", "landmarks.png", "trajectory.tum", "summary.yaml", "report.md"})
        self.assertEqual(max(png_size(offline["landmarks.png"])), 1000)
        robot = self.robot()
        node = self.node(program="landmarks")
        robot.wait_until_heard(heard_by("landmarks"))
        drive(robot)
        node.wait_for("sightings", used=len(STEPS))
        self.assertEqual(self.saved(node)["landmarks.yaml"], offline["landmarks.yaml"])


if __name__ == "__main__":
    case.run("landmarks_map", LandmarksMap)
