# SPDX-License-Identifier: BSD-3-Clause
"""The nodes, each with what it hears on a round, so that one test can be made of all of them."""
import collections
import functools

from portolan_testing import beacons, hall, landmarks, messages
from portolan_testing.robot import SONAR_YAWS
from portolan_testing.room import Room

# How a node's inputs are called in diagnostics, by topic; the parameters that it runs with; the file that ~save leaves
# and that tells nothing of when; a parameter of its own, with a value of a wrong type and one out of its range; and
# what it hears: `look(step, stamp)` gives pairs (topic, message).
Subject = collections.namedtuple("Subject", "nouns parameters files wrong_type out_of_range look")

ROOM = Room(half_side=5.05)
PILLARS = [(x + 0.05, y + 0.05, 0.1 * z - 0.35) for x in (-4.0, 0.0, 4.0) for y in (-3.0, 2.0, 7.0) for z in range(8)]
PLACES = {0: (3.0, 1.0), 5: (-2.5, 3.5), 2000000000: (0.5, 6.0)}
LAMPS = {101: (1.0, 1.0, 3.0), 102: (-1.0, 3.0, 3.0)}
FOCAL_LENGTH = 400.0  # [pixel]
pose_of = beacons.way


@functools.lru_cache(maxsize=None)
def ranges_at(step):
    return ROOM.scan(pose_of(step), beams=180)


@functools.lru_cache(maxsize=None)
def echo_at(step):
    x, y, yaw = pose_of(step)
    return ROOM.echo((x, y, yaw + SONAR_YAWS[0]), messages.APERTURE)


def scan(step, stamp):
    return "scan", messages.scan(stamp, "laser", ranges_at(step))


def echo(step, stamp):
    return "sonar", messages.echo(stamp, "sonar_0", echo_at(step))


def cloud(step, stamp):
    return "cloud_in", messages.cloud(stamp, "camera", hall.seen_from(pose_of(step), PILLARS))


def sightings(step, stamp):
    seen = [landmarks.sighting(id_, *landmarks.range_and_bearing(place, pose_of(step)), range_stddev=0.05,
                               azimuth_stddev=0.02) for id_, place in PLACES.items()]
    return "landmark_sightings", landmarks.sightings(stamp, "laser", seen)


def image(step, stamp):
    """Of lamps above, by a camera that looks up."""
    seen = [(id_, 320.0 + FOCAL_LENGTH * x / z, 240.0 + FOCAL_LENGTH * y / z) for id_, (x, y, z)
            in zip(LAMPS, hall.seen_from(pose_of(step), list(LAMPS.values())))]
    return "image_features", landmarks.features(stamp, seen)


def calibration(_, stamp):
    return "camera_info", landmarks.calibration(stamp, FOCAL_LENGTH)


def ranges(step, stamp):
    return "beacon_ranges", messages.ranges(stamp, "antenna", beacons.heard_from(PLACES, pose_of(step)))


def sees(*sensors):
    """What these sensors say at a step, each a little before the next."""
    early = [0.001 * i for i in reversed(range(len(sensors)))]
    return lambda step, stamp: [sensor(step, stamp - before) for sensor, before in zip(sensors, early)]


SUBJECTS = {
    "occupancy_grid": Subject({"scan": "scans", "sonar": "echoes", "cloud_in": "clouds"}, {"resolution": 0.1},
                              "map", {"resolution": "wide"}, {"laser": {"p_occupied": 1.5}}, sees(scan, echo, cloud)),
    "octomap": Subject({"cloud_in": "clouds", "scan": "scans"}, {"resolution": 0.1}, "octomap", {"resolution": "wide"},
                       {"sensor_model": {"hit": 0.3}}, sees(cloud, scan)),
    "landmarks": Subject({"landmark_sightings": "sightings", "image_features": "images", "camera_info": "calibrations"},
                         {}, "landmarks", {"noise": {"range_stddev": []}}, {"noise": {"azimuth_stddev": -1.0}},
                         sees(calibration, sightings, image)),
    "beacons": Subject({"beacon_ranges": "rangings"}, {}, "beacons", {"noise": "some"}, {"dimension": 4}, sees(ranges)),
    "pose_graph": Subject({"scan": "scans"}, {}, "pose_graph.g2o", {"scan_topics": "scan"},
                          {"keyframes": {"min_travel": -0.5}}, sees(scan)),
}
