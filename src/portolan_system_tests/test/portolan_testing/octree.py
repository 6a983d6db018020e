# SPDX-License-Identifier: BSD-3-Clause
"""Octrees as they come, decoded from what is published about their nodes."""
import struct
import threading

import numpy
import rospy
from octomap_msgs.msg import Octomap
from visualization_msgs.msg import Marker, MarkerArray

SIDE = 65536     # voxels along an axis of the tree
MIDDLE = SIDE // 2


def corner_of_child(corner, size, i):
    """The lowest voxel of child i of a cube: bits of i are x, y, z."""
    return tuple(corner[axis] + (size // 2 if i >> axis & 1 else 0) for axis in range(3))


class Octree:
    """The leaves of a tree: lowest voxel -> (side in voxels, value)."""

    def __init__(self, data, resolution, binary):
        self.resolution = resolution
        self.leaves = {}
        self._bytes = bytes(byte & 0xff for byte in data)
        self._position = 0
        if self._bytes:
            (self._read_binary if binary else self._read_full)((0, 0, 0), SIDE)
        assert self._position == len(self._bytes), "bytes are left over"

    @classmethod
    def of(cls, message):
        assert message.id == "OcTree", message.id
        return cls(message.data, message.resolution, message.binary)

    @classmethod
    def of_file(cls, content):
        """Of a .ot or .bt file."""
        head, data = content.split(b"\ndata\n", 1)
        lines = dict(line.split(b" ", 1) for line in head.split(b"\n")[1:] if not line.startswith(b"#"))
        assert lines[b"id"] == b"OcTree", lines
        return cls(data, float(lines[b"res"]), b"binary" in head.split(b"\n")[0])

    def _take(self, size):
        self._position += size
        assert self._position <= len(self._bytes), "the data are cut off"
        return self._bytes[self._position - size:self._position]

    def _read_full(self, corner, size):
        """A node: its log-odds, a byte that says which children it has, then these."""
        log_odds, children = struct.unpack("<fB", self._take(5))
        if children == 0:
            self.leaves[corner] = (size, log_odds)
        for i in range(8):
            if children >> i & 1:
                self._read_full(corner_of_child(corner, size, i), size // 2)

    def _read_binary(self, corner, size):
        """A node: two bits for each child (0 none, 1 free, 2 occupied, 3 with children), then those with children."""
        kinds, = struct.unpack("<H", self._take(2))
        for i in range(8):
            child = corner_of_child(corner, size, i)
            kind = kinds >> 2 * i & 3
            if kind == 3:
                self._read_binary(child, size // 2)
            elif kind:
                self.leaves[child] = (size // 2, 1.0 if kind == 2 else -1.0)

    def at(self, x, y, z):
        """The value at a point [m]; None where nothing is known."""
        key = [int(numpy.floor(p / self.resolution)) + MIDDLE for p in (x, y, z)]
        size = 1
        while size <= SIDE:
            leaf = self.leaves.get(tuple(k // size * size for k in key))
            if leaf and leaf[0] == size:
                return leaf[1]
            size *= 2
        return None

    def voxels(self, occupied):
        """The voxels that are occupied, or free, in leaves of any size."""
        found = set()
        for (x, y, z), (size, value) in self.leaves.items():
            if (value >= 0.0) == occupied:
                assert size <= 64, "too many voxels to list"
                found.update((x + i, y + j, z + k) for i in range(size) for j in range(size) for k in range(size))
        return found


def voxels_of_cloud(message, resolution):
    """The voxels that hold the points of a dense cloud of x, y, z."""
    points = numpy.frombuffer(message.data, dtype="<f4").reshape(-1, 3).astype(float)
    keys = numpy.floor(points / resolution).astype(int) + MIDDLE
    return set(map(tuple, keys.tolist()))


class Cubes:
    """What rviz makes of a topic of cubes."""

    def __init__(self, topic):
        self._lock = threading.Lock()
        self._markers = {}
        self.frames = set()
        self._subscriber = rospy.Subscriber(topic, MarkerArray, self._take)

    def _take(self, message):
        with self._lock:
            for marker in message.markers:
                self.frames.add(marker.header.frame_id)
                if marker.action == Marker.DELETEALL:
                    self._markers.clear()
                elif marker.action == Marker.DELETE:
                    self._markers.pop((marker.ns, marker.id), None)
                else:
                    assert len(marker.points) == len(marker.colors)
                    self._markers[marker.ns, marker.id] = marker

    def voxels(self, resolution):
        with self._lock:
            points = [p for marker in self._markers.values() for p in marker.points]
        return {tuple(int(numpy.floor(c / resolution)) + MIDDLE for c in (p.x, p.y, p.z)) for p in points}

    def close(self):
        self._subscriber.unregister()


class Latest:
    """The last message of a topic."""

    def __init__(self, topic, type_=Octomap):
        self.message = None
        self._subscriber = rospy.Subscriber(topic, type_, self._take)

    def _take(self, message):
        self.message = message

    def close(self):
        self._subscriber.unregister()
