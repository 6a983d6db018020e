# SPDX-License-Identifier: BSD-3-Clause
"""Small recordings of a robot in the room."""
import math

import rosbag

from portolan_testing import messages
from portolan_testing.node import executable
from portolan_testing.robot import mounts, views
from portolan_testing.room import Room

BEGIN = 1000.0  # [s]
SONARS = (0, 3, 7)
SWEEP = 0.04    # from a scan's first beam to its last [s]


def way(stamp):
    """Pose (x, y, yaw) of the robot as it goes a small circle."""
    t = stamp - BEGIN
    return (0.6 * math.sin(0.3 * t), 0.6 - 0.6 * math.cos(0.3 * t), 0.3 * t)


def tf_stamps(looks):
    """From before the first look to beyond the last."""
    return [BEGIN - 0.2 + 0.02 * i for i in range(5 * looks + 25)]


def broken(ranges, look):
    """The same with a few values that stand for no distance."""
    odd = [math.nan, math.inf, -math.inf, 0.0, -1.0, 1e30]
    spoilt = list(ranges)
    for i in range(look % 5, len(spoilt), 11):
        spoilt[i] = odd[(look + i) % len(odd)]
    return spoilt


def write_room_bag(path, looks=60, with_mounts=True, with_tf=True):
    """`looks` scans and three times as many echoes, ten a second, and tf at 50 Hz. Gives the path."""
    room = Room()
    events = []
    if with_mounts:
        events.append((BEGIN - 0.25, "/tf_static", mounts()))
    for stamp in tf_stamps(looks) if with_tf else ():
        events.append((stamp, "/tf", messages.transforms(
            messages.transform(stamp, "odom", "base_link", way(stamp)))))
    for look in range(looks):
        stamp = BEGIN + 0.1 * look
        scan, echoes = views(room, stamp, way(stamp), sonars=SONARS)
        scan = messages.scan(stamp, "laser", broken(scan.ranges, look), sweep=SWEEP)
        events.append((stamp, "/scan", scan))
        events += [(stamp, "/sonar", echo) for echo in echoes]
    with rosbag.Bag(str(path), "w") as bag:
        for stamp, topic, message in sorted(events, key=lambda event: event[0]):
            bag.write(topic, message, messages.time(stamp))
    return path


def play_command(bag, namespace, rate):
    """The command that plays the bag into the namespace, its clock too, once all its topics are heard."""
    return [executable("play", package="rosbag"), "--clock", "--hz=200", "--quiet", f"--rate={rate}",
            f"--prefix={namespace}", "--wait-for-subscribers", str(bag), f"clock:={namespace}/clock"]
