# SPDX-License-Identifier: BSD-3-Clause
"""Occupancy grids as they come: decoded, put together from updates, and read from files."""
import pathlib
import threading
import zlib

import numpy
import rospy
from map_msgs.msg import OccupancyGridUpdate
from nav_msgs.msg import OccupancyGrid


class Grid:
    """The cells of a map by their place in the world."""

    def __init__(self, message):
        info = message.info
        self.frame = message.header.frame_id
        self.resolution = info.resolution
        self.cells = numpy.array(message.data, dtype=numpy.int8).reshape(info.height, info.width)
        self.column_0 = round(info.origin.position.x / info.resolution)
        self.row_0 = round(info.origin.position.y / info.resolution)

    def at(self, x, y):
        """P(occupied) in percent at this point [m], -1 where it is unknown."""
        column = int(numpy.floor(x / self.resolution)) - self.column_0
        row = int(numpy.floor(y / self.resolution)) - self.row_0
        rows, columns = self.cells.shape
        return int(self.cells[row, column]) if 0 <= row < rows and 0 <= column < columns else -1

    def apply(self, update):
        rows, columns = slice(update.y, update.y + update.height), slice(update.x, update.x + update.width)
        self.cells[rows, columns] = numpy.array(update.data, dtype=numpy.int8).reshape(update.height, update.width)

    def known(self):
        """All that it knows, as a set of (column, row, percent): equal for equal maps of any extent."""
        rows, columns = numpy.nonzero(self.cells >= 0)
        values = self.cells[rows, columns]
        return set(zip((columns + self.column_0).tolist(), (rows + self.row_0).tolist(), values.tolist()))


class GridListener:
    """What rviz or a costmap makes of a map's topic and its updates."""

    def __init__(self, topic):
        self._lock = threading.Lock()
        self._grid = None
        self._stamp = None
        self.wholes = []   # messages
        self.updates = []
        self._subscribers = [rospy.Subscriber(topic, OccupancyGrid, self._take_whole),
                             rospy.Subscriber(topic + "_updates", OccupancyGridUpdate, self._take_update)]

    def _take_whole(self, message):
        with self._lock:
            self.wholes.append(message)
            if self._stamp is not None and message.header.stamp < self._stamp:
                self.updates.clear()  # the clock ran back: they are of another time
            self._grid, self._stamp = Grid(message), message.header.stamp
            for update in self.updates:  # two topics: one may overtake the other
                if update.header.stamp > self._stamp:
                    self._grid.apply(update)

    def _take_update(self, message):
        with self._lock:
            self.updates.append(message)
            if self._grid is not None and message.header.stamp >= self._stamp:
                self._grid.apply(message)

    def known(self):
        with self._lock:
            return self._grid.known() if self._grid is not None else set()

    def at(self, x, y):
        """As Grid.at; -1 while no map has come."""
        with self._lock:
            return self._grid.at(x, y) if self._grid is not None else -1

    def close(self):
        for subscriber in self._subscribers:
            subscriber.unregister()


def files_of(folder, begins="map"):
    """Names and bytes of the files in the folder whose names begin so."""
    return {path.name: path.read_bytes() for path in sorted(pathlib.Path(folder).glob(begins + "*"))}


def read_pgm(path):
    """The pixels of a P5 file, top row first."""
    head, _, rest = pathlib.Path(path).read_bytes().partition(b"\n")
    assert head == b"P5", head
    lines = rest.split(b"\n")
    while lines[0].startswith(b"#"):
        lines = lines[1:]
    numbers, body = [], b"\n".join(lines)
    while len(numbers) < 3:
        line, _, body = body.partition(b"\n")
        numbers += [int(word) for word in line.split()]
    width, height, most = numbers
    assert most == 255 and len(body) == width * height, (numbers, len(body))
    return numpy.frombuffer(body, dtype=numpy.uint8).reshape(height, width)


def png_size(content):
    """Width and height of an RGB picture all of whose pixels can be unpacked."""
    assert content[:8] == b"\x89PNG\r\n\x1a\n"
    position, chunks = 8, {}
    while position < len(content):
        length = int.from_bytes(content[position:position + 4], "big")
        name, data = content[position + 4:position + 8], content[position + 8:position + 8 + length]
        check = int.from_bytes(content[position + 8 + length:position + 12 + length], "big")
        assert zlib.crc32(name + data) == check
        chunks[name] = chunks.get(name, b"") + data
        position += 12 + length
    width, height = (int.from_bytes(chunks[b"IHDR"][i:i + 4], "big") for i in (0, 4))
    assert b"IEND" in chunks and len(zlib.decompress(chunks[b"IDAT"])) == height * (1 + 3 * width)
    return width, height
