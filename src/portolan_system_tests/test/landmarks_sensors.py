#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A simulated robot sees marks and pillars with four sensors; each feeds a landmarks node, and the simulator's truth judges them."""
import math

import numpy
import rospy
from portolan_msgs.msg import Landmark, LandmarkMap
from std_msgs.msg import Bool

from portolan_testing import case
from portolan_testing.node import Node
from portolan_testing.waiting import eventually

MARKS = {1: (0.2, 1.0, 0.6), 2: (0.2, 4.5, 0.9), 3: (2.0, 5.8, 0.5), 4: (4.2, 5.8, 1.0), 5: (7.0, 5.8, 0.7),
         6: (7.8, 4.0, 0.4), 7: (7.8, 1.5, 0.8), 8: (6.0, 0.2, 0.6), 9: (3.5, 0.2, 0.9), 10: (1.5, 0.2, 0.4)}
PILLARS = [(2.5, 3.0), (5.6, 3.2), (4.1, 2.4)]
EXACT = {f"alpha{i}": 0.0 for i in range(1, 5)}
SIMULATOR = {
    "seed": 5, "real_time_factor": 6.0, "odometry": EXACT, "sonar_rings": [],
    "wait_for_subscribers": ["known", "nameless", "image_features", "camera_info", "scan", "path_finished"],
    "world": {"walls": [{"points": [[0, 0], [8, 0], [8, 6], [0, 6], [0, 0]]}],
              "cylinders": [{"center": list(center), "radius": 0.15} for center in PILLARS],
              "landmarks": [{"id": id_, "position": list(place)} for id_, place in MARKS.items()],
              "tour": [[1.2, 1.2], [6.8, 1.2], [6.8, 4.8], [1.2, 4.8], [1.2, 1.6]]},
    "landmark_sensors": [
        {"frame": "knowing", "topic": "known", "rate": 5},
        {"frame": "blind", "topic": "nameless", "rate": 5, "identities": False, "false_positives": 0.3}],
    "cameras": [{"rate": 10}]}
QUIET = {f"{name}_topics": [] for name in ("landmark_sightings", "image_features", "camera_info", "landmark_scan")}


class Listener:
    """The last map of one node."""

    def __init__(self, namespace):
        self._landmarks = []
        self._subscriber = rospy.Subscriber(f"{namespace}/landmarks", LandmarkMap, self._take)

    def _take(self, message):
        self._landmarks = message.landmarks

    def points(self):
        """Identity to place and covariance, of those whose depth is known."""
        return {m.id: (numpy.array([m.position.x, m.position.y, m.position.z]),
                       numpy.array(m.covariance).reshape(3, 3))
                for m in self._landmarks if m.kind == Landmark.POINT}

    def errors(self, truth):
        """Identity to the distance from the nearest true place, in as many dimensions as that has."""
        return {id_: min(math.dist(place[:len(true)], true) for true in truth)
                for id_, (place, _) in self.points().items()}

    def close(self):
        self._subscriber.unregister()


class LandmarksSensors(case.NodeCase):
    def mapper(self, name, **parameters):
        """A node of its own for one sensor of the robot, and what it maps."""
        namespace = f"{self.namespace}/{name}"
        topics = {f"/{topic}": f"{self.namespace}/{topic}" for topic in ("tf", "tf_static", "clock")}
        named = {key: [f"{self.namespace}/{topic}" for topic in value] if key.endswith("_topics") else value
                 for key, value in {**QUIET, **parameters}.items()}
        self.node(namespace, program="landmarks", parameters=named, remap=topics)
        return self.closing(Listener(namespace))

    def assert_nees(self, points, truth):
        """The squared errors fit the covariances: 1 a dimension, and not twice that over so many."""
        squared = [error @ numpy.linalg.solve(covariance, error)
                   for error, covariance in ((place - truth[id_], covariance)
                                             for id_, (place, covariance) in points.items())]
        self.assertLess(sum(squared) / (3 * len(squared)), 2.0)

    def test_each_sensor_maps_what_is_there(self):
        known = self.mapper("by_name", landmark_sightings_topics=["known"])
        nameless = self.mapper("by_place", landmark_sightings_topics=["nameless"])
        camera = self.mapper("by_image", image_features_topics=["image_features"], camera_info_topics=["camera_info"],
                             noise={"pixel_stddev": 0.5})
        poles = self.mapper("by_laser", landmark_scan_topics=["scan"])
        arrived = []
        end = rospy.Subscriber(f"{self.namespace}/path_finished", Bool, arrived.append)
        self.addCleanup(end.unregister)
        self.closing(Node(self.namespace, program="robot_sim", parameters=SIMULATOR))
        eventually(lambda: arrived and arrived[-1].data, "the robot is at the path's end", seconds=90.0)

        truth = {id_: numpy.array(place) for id_, place in MARKS.items()}
        places = list(MARKS.values())
        eventually(lambda: known.points().keys() == MARKS.keys(), "every mark is mapped by its name")
        eventually(lambda: max(math.dist(place, truth[id_]) for id_, (place, _) in known.points().items()) < 0.03,
                   lambda: f"marks are where they are, not off by {known.errors(places)}")
        self.assert_nees(known.points(), truth)

        def is_right(errors, count, limit):
            return len(errors) == count and max(errors.values()) < limit

        eventually(lambda: is_right(nameless.errors(places), len(MARKS), 0.03),
                   lambda: f"as many as there are, and nothing that was imagined: {nameless.errors(places)}")
        eventually(lambda: is_right(poles.errors(PILLARS), len(PILLARS), 0.02),
                   lambda: f"the laser finds the pillars and nothing else: {poles.errors(PILLARS)}")
        eventually(lambda: camera.points().keys() == MARKS.keys(), lambda: f"images give depth to all: {camera.errors(places)}")
        self.assertLess(max(math.dist(place, truth[id_]) for id_, (place, _) in camera.points().items()), 0.05)
        self.assert_nees(camera.points(), truth)


if __name__ == "__main__":
    case.run("landmarks_sensors", LandmarksSensors)
