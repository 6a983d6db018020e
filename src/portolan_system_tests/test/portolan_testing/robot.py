# SPDX-License-Identifier: BSD-3-Clause
"""The drivers of a robot with a laser and sonars, in a namespace of its own."""
import math

import rospy
from nav_msgs.msg import Odometry
from portolan_msgs.msg import BeaconRanges, DriftCorrection, ImageFeatures, LandmarkSightings
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import CameraInfo, LaserScan, PointCloud2, Range
from tf2_msgs.msg import TFMessage

from portolan_testing import messages
from portolan_testing.waiting import eventually

SONARS = 12
ANTENNA = (0.3, -0.2, 0.0)  # on the base: x, y [m], yaw
SONAR_YAWS = [2.0 * math.pi * i / SONARS for i in range(SONARS)]

TOPICS = {"tf": TFMessage, "tf_static": TFMessage, "scan": LaserScan, "sonar": Range, "cloud_in": PointCloud2,
          "landmark_sightings": LandmarkSightings, "image_features": ImageFeatures, "camera_info": CameraInfo,
          "beacon_ranges": BeaconRanges}
SENSORS = {"occupancy_grid": ("scan", "sonar", "cloud_in"), "octomap": ("cloud_in", "scan"),
           "landmarks": ("landmark_sightings", "image_features", "camera_info"), "beacons": ("beacon_ranges",),
           "pose_graph": ("scan",)}


def heard_by(program):
    """The topics to which this node listens by default."""
    return ("tf", "tf_static", *SENSORS[program])


def mounts(prefix=""):
    """Where the sensors sit on the robot: transforms for tf_static."""
    base = prefix + "base_link"
    sensors = [(f"{prefix}sonar_{i}", (0.0, 0.0, yaw)) for i, yaw in enumerate(SONAR_YAWS)]
    sensors += [(prefix + "laser", (0.0, 0.0, 0.0)), (prefix + "camera", (0.0, 0.0, 0.0)),
                (prefix + "antenna", ANTENNA)]
    return messages.transforms(*(messages.transform(1.0, base, name, pose) for name, pose in sensors))


def views(room, stamp, pose, prefix="", sonars=range(SONARS)):
    """What the sensors say from pose (x, y, yaw): a scan and the echoes of these sonars."""
    x, y, yaw = pose
    echoes = [messages.echo(stamp, f"{prefix}sonar_{i}",
                            room.echo((x, y, yaw + SONAR_YAWS[i]), messages.APERTURE)) for i in sonars]
    return messages.scan(stamp, prefix + "laser", room.scan(pose)), echoes


class Robot:
    """Publishes tf, scans, echoes, clouds, drift corrections and, where it is asked to, the clock."""

    def __init__(self, namespace, prefix="", tf="tf", tf_static="tf_static"):
        self.namespace = namespace
        self.prefix = prefix
        self.sent = {}  # messages by topic
        names = dict.fromkeys(TOPICS)
        names.update(tf=tf, tf_static=tf_static)
        self._publishers = {topic: self._publisher(names[topic] or topic, type_, topic == "tf_static")
                            for topic, type_ in TOPICS.items()}
        self._publishers["drift_correction"] = self._publisher("drift_correction", DriftCorrection, True)
        self._publishers["clock"] = self._publisher("clock", Clock, True)
        self._publishers["odom"] = self._publisher("odom", Odometry)
        self.mount()

    def mount(self):
        """Says where the sensors sit."""
        self.send("tf_static", mounts(self.prefix))

    def _publisher(self, topic, type_, latch=False):
        return rospy.Publisher(rospy.names.ns_join(self.namespace, topic), type_, queue_size=1000, latch=latch)

    def wait_until_heard(self, topics=heard_by("occupancy_grid"), listeners=1):
        eventually(lambda: all(self._publishers[t].get_num_connections() >= listeners for t in topics),
                   f"a node listens to {topics} of {self.namespace}")

    def send(self, topic, message):
        self._publishers[topic].publish(message)
        self.sent[topic] = self.sent.get(topic, 0) + 1

    def tick(self, now):
        """Sets the clock [s]."""
        self.send("clock", Clock(messages.time(now)))

    def stand(self, stamp, pose):
        """Odometry by tf: the base at pose (x, y, yaw)."""
        self.send("tf", messages.transforms(
            messages.transform(stamp, self.prefix + "odom", self.prefix + "base_link", pose)))

    def look(self, room, stamp, pose=(0.0, 0.0, 0.0), seen_as=None):
        """Stands there, or believes to (`seen_as` is what odometry says), and sends all its sensors."""
        self.stand(stamp, seen_as or pose)
        scan, echoes = views(room, stamp, pose, self.prefix)
        self.send("scan", scan)
        for echo in echoes:
            self.send("sonar", echo)

    def look_around(self, room, stamps, pose=(0.0, 0.0, 0.0)):
        for stamp in stamps:
            self.look(room, stamp, pose)

    def close(self):
        for publisher in self._publishers.values():
            publisher.unregister()
