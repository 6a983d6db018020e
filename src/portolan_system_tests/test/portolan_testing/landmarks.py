# SPDX-License-Identifier: BSD-3-Clause
"""What a robot says that sees landmarks."""
import math

from portolan_msgs.msg import ImageFeature, ImageFeatures, LandmarkSighting, LandmarkSightings
from sensor_msgs.msg import CameraInfo

from portolan_testing import messages


def sighting(id_, range_, azimuth, elevation=math.nan, **more):
    return LandmarkSighting(id=id_, range=range_, azimuth=azimuth, elevation=elevation, **more)


def sightings(stamp, frame, list_):
    message = LandmarkSightings(sightings=list_)
    message.header.stamp, message.header.frame_id = messages.time(stamp), frame
    return message


def calibration(stamp, focal_length):
    message = CameraInfo(K=[focal_length, 0.0, 320.0, 0.0, focal_length, 240.0, 0.0, 0.0, 1.0])
    message.header.stamp, message.header.frame_id = messages.time(stamp), "camera"
    return message


def features(stamp, list_):
    message = ImageFeatures(features=[ImageFeature(id=id_, u=u, v=v) for id_, u, v in list_])
    message.header.stamp, message.header.frame_id = messages.time(stamp), "camera"
    return message


def range_and_bearing(place, pose):
    """Of a point (x, y) from pose (x, y, yaw)."""
    dx, dy = place[0] - pose[0], place[1] - pose[1]
    return math.hypot(dx, dy), math.remainder(math.atan2(dy, dx) - pose[2], 2.0 * math.pi)
