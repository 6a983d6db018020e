# SPDX-License-Identifier: BSD-3-Clause
"""Sensor messages and transforms, from plain numbers. Stamps are seconds."""
import math
import struct

import rospy
from geometry_msgs.msg import Pose, TransformStamped
from nav_msgs.msg import Odometry
from portolan_msgs.msg import BeaconRange, BeaconRanges, DriftCorrection
from sensor_msgs.msg import LaserScan, PointCloud2, PointField, Range
from tf2_msgs.msg import TFMessage

APERTURE = math.radians(30.0)  # of the sonars [rad]


def time(stamp):
    """A stamp that is exact to the nanosecond where `stamp` has a few decimals."""
    return rospy.Time(*divmod(round(stamp * 1e9), 10**9))


def fill_planar(position, orientation, pose):
    x, y, yaw = pose
    position.x, position.y, position.z = x, y, 0.0
    orientation.x, orientation.y = 0.0, 0.0
    orientation.z, orientation.w = math.sin(yaw / 2.0), math.cos(yaw / 2.0)


def transform(stamp, parent, child, pose):
    """Of child in parent, at pose (x, y, yaw)."""
    message = TransformStamped()
    message.header.stamp = time(stamp)
    message.header.frame_id, message.child_frame_id = parent, child
    fill_planar(message.transform.translation, message.transform.rotation, pose)
    return message


def transforms(*items):
    return TFMessage(transforms=list(items))


def odometry(stamp, parent, child, pose):
    message = Odometry()
    message.header.stamp = time(stamp)
    message.header.frame_id, message.child_frame_id = parent, child
    fill_planar(message.pose.pose.position, message.pose.pose.orientation, pose)
    return message


def scan(stamp, frame, ranges, sweep=0.0):
    """All around, the first beam backwards; `sweep` [s] from the first beam to the last."""
    message = LaserScan()
    message.header.stamp, message.header.frame_id = time(stamp), frame
    message.angle_min = -math.pi
    message.angle_increment = 2.0 * math.pi / len(ranges) if ranges else 0.1
    message.angle_max = message.angle_min + message.angle_increment * (len(ranges) - 1)
    message.time_increment = sweep / (len(ranges) - 1) if sweep else 0.0
    message.range_min, message.range_max = 0.05, 10.0
    message.ranges = ranges
    return message


def echo(stamp, frame, range_, aperture=APERTURE):
    message = Range(radiation_type=Range.ULTRASOUND, field_of_view=aperture, min_range=0.05, max_range=4.0)
    message.header.stamp, message.header.frame_id = time(stamp), frame
    message.range = range_
    return message


def cloud(stamp, frame, points):
    """Of points (x, y, z) [m]."""
    message = PointCloud2(height=1, width=len(points), point_step=12, row_step=12 * len(points), is_dense=True)
    message.header.stamp, message.header.frame_id = time(stamp), frame
    message.fields = [PointField(name, 4 * i, PointField.FLOAT32, 1) for i, name in enumerate("xyz")]
    message.data = b"".join(struct.pack("<3f", *point) for point in points)
    return message


def ranges(stamp, frame, ranges_, stddev=0.1):
    """Of pairs (id of the beacon, range [m])."""
    message = BeaconRanges(ranges=[BeaconRange(id=id_, range=range_, stddev=stddev) for id_, range_ in ranges_])
    message.header.stamp, message.header.frame_id = time(stamp), frame
    return message


def correction(knots, child="odom"):
    """Of odometry's drift: knots (stamp, (x, y, yaw))."""
    message = DriftCorrection(child_frame_id=child)
    message.header.frame_id = "map"
    for stamp, pose in knots:
        message.stamps.append(time(stamp))
        message.poses.append(Pose())
        fill_planar(message.poses[-1].position, message.poses[-1].orientation, pose)
    return message
