# SPDX-License-Identifier: BSD-3-Clause
"""What sensors, tf and clocks get wrong: each message in a window of time is broken, always in the same way."""
import copy
import itertools
import math
import struct

import rospy

CLOCK, POSES = ("clock",), ("tf",)
MOST = 2**32 - 1


def stamp_of(message):
    """The time [s] that a message is about."""
    if hasattr(message, "clock"):
        return message.clock.to_sec()
    return (message.transforms[0] if hasattr(message, "transforms") else message).header.stamp.to_sec()


def moved(message, seconds):
    """The same message of another time."""
    message, step = copy.deepcopy(message), rospy.Duration(seconds)
    if hasattr(message, "clock"):
        message.clock += step
    for part in getattr(message, "transforms", [message] if hasattr(message, "header") else []):
        part.header.stamp += step
    return message


def changed(message, **fields):
    message = copy.copy(message)
    for name, value in fields.items():
        setattr(message, name, value)
    return message


def each(items, **fields):
    """Copies of a message's parts in which each of the fields, where a part has it, is the next of its values."""
    return [changed(item, **{name: next(values) for name, values in fields.items() if hasattr(item, name)})
            for item in items]


def measuring(message, values):
    """The same message in which all that was measured is one of these values, in turn."""
    values, kind = itertools.cycle(values), message._type.split("/")[1]
    if kind == "LaserScan":
        return changed(message, ranges=[next(values) for _ in message.ranges])
    if kind == "Range":
        return changed(message, range=list(itertools.islice(values, 1 + round(10.0 * stamp_of(message)) % 2))[-1])
    if kind == "PointCloud2":
        return changed(message, data=b"".join(struct.pack("<f", next(values)) for _ in range(len(message.data) // 4)))
    if kind == "CameraInfo":
        return changed(message, K=[next(values) for _ in message.K])
    part = {"LandmarkSightings": "sightings", "ImageFeatures": "features", "BeaconRanges": "ranges"}[kind]
    return changed(message, **{part: each(getattr(message, part), range=values, azimuth=values, u=values, v=values)})


def unsure(message, value):
    """The same message with this in place of each standard deviation and variance."""
    if hasattr(message, "pose"):
        message = copy.deepcopy(message)
        message.pose.covariance = [value] * 36
        return message
    part = {"LandmarkSightings": "sightings", "BeaconRanges": "ranges"}.get(message._type.split("/")[1])
    if part is None:
        return message
    same = itertools.repeat(value)
    return changed(message, **{part: each(getattr(message, part), stddev=same, range_stddev=same, azimuth_stddev=same,
                                          elevation_stddev=same)})


def cut(message):
    """The same message, of which only half goes over the wire; its lengths speak of all."""
    def serialize(self, buffer):
        begin = buffer.tell()
        type(message).serialize(self, buffer)
        buffer.truncate(buffer.seek(begin + (buffer.tell() - begin) // 2))
    torn = type("Cut", (type(message),), {"serialize": serialize, "__slots__": ()})()
    for name in message.__slots__:
        setattr(torn, name, getattr(message, name))
    return torn


def is_cut(message):
    return type(message).__name__ == "Cut"


def wrong_sizes(message):
    """Cut on the wire; and, where it has sizes of its own, whole with sizes that contradict each other."""
    wrong = {"LaserScan": dict(angle_increment=0.0), "Range": dict(field_of_view=-1.0),
             "PointCloud2": dict(width=MOST, row_step=MOST)}.get(message._type.split("/")[1])
    return [cut(message)] + ([changed(message, **wrong)] if wrong else [])


def turned(message, factor):
    """Transforms with quaternions so much too long."""
    message = copy.deepcopy(message)
    for transform in message.transforms:
        q = transform.transform.rotation
        q.x, q.y, q.z, q.w = (factor * part for part in (q.x, q.y, q.z, q.w))
    return message


def far_away(message):
    message = copy.deepcopy(message)
    for transform in message.transforms:
        transform.transform.translation.x = 1e30
    return message


def looping(message):
    """Transforms, and their parents as their children; and frames of which each is the other's parent."""
    message = copy.deepcopy(message)
    for transform in list(message.transforms):
        for parent, child in ((transform.child_frame_id, transform.header.frame_id), ("hen", "egg"), ("egg", "hen")):
            back = copy.deepcopy(transform)
            back.header.frame_id, back.child_frame_id = parent, child
            message.transforms.append(back)
    return message


def nowhere(message):
    message = copy.deepcopy(message)
    message.header.frame_id = "nowhere" if round(10.0 * stamp_of(message)) % 2 else ""
    return message


def late(message, held):
    """Transforms come half a second after their time, when newer ones are sent."""
    held.append(message)
    due = [one for one in held if stamp_of(one) <= stamp_of(message) - 0.499]
    held[:] = held[len(due):]
    return due


def swapped(message, held):
    """Every second message comes before the one that it follows."""
    if not held:
        held.append(message)
        return []
    return [message, held.pop()]


def burst(message, _):
    return [message] + [moved(message, 0.009 * i) for i in range(1, 10)]


def alone(change):
    """A fault that makes one message of one."""
    return lambda message, _: [change(message)]


# Name: what it does to a message, given those of its topic that it holds back, and to which topics (None: sensors').
FAULTS = {
    "none": (lambda message, _: [message], ()),
    "clock_back": (alone(lambda m: moved(m, -100.0)), "from then on"),
    "clock_forward_by_a_day": (alone(lambda m: moved(m, 86400.0)), "from then on"),
    "repeated_stamps": (lambda message, _: [message, message], None),
    "decreasing_stamps": (swapped, None),
    "tf_late": (late, POSES),
    "tf_absent": (lambda message, _: [], POSES),
    "tf_loop": (alone(looping), POSES),
    "nan_storm": (alone(lambda m: measuring(m, [math.nan])), None),
    "infinities": (alone(lambda m: measuring(m, [math.inf, -math.inf])), None),
    "empty_messages": (alone(lambda m: type(m)(header=m.header)), None),
    "malformed_sizes": (lambda message, _: wrong_sizes(message), None),
    "coordinates_of_1e30": (alone(lambda m: measuring(m, [1e30])), None),
    "poses_of_1e30": (alone(far_away), POSES),
    "unknown_frames": (alone(nowhere), None),
    "zero_covariance": (alone(lambda m: unsure(m, 0.0)), None),
    "negative_covariance": (alone(lambda m: unsure(m, -1.0)), None),
    "nan_covariance": (alone(lambda m: unsure(m, math.nan)), None),
    "non_unit_quaternion": (alone(lambda m: turned(m, 2.0 * (round(10.0 * stamp_of(m)) % 2))), POSES),
    "rate_ten_times_too_high": (burst, None),
}


class Injector:
    """Breaks the messages from `begin` to before `end` [s, by their stamps]; all others it passes on."""

    def __init__(self, fault="none", begin=0.0, end=math.inf):
        self._change, self._topics = FAULTS[fault]
        self._begin, self._end = begin, end
        self._held = {}

    def _concerns(self, topic, stamp):
        if self._topics == "from then on":
            return stamp >= self._begin
        of_sensor = topic not in CLOCK + POSES + ("tf_static",)
        return (of_sensor if self._topics is None else topic in self._topics) and self._begin <= stamp < self._end

    def __call__(self, topic, message):
        """What comes out of the topic for this message: none, one or several."""
        held = self._held.setdefault(topic, [])
        if topic != "tf_static" and self._concerns(topic, stamp_of(message)):
            return self._change(message, held)
        before, held[:] = list(held), []
        return before + [message]
