# SPDX-License-Identifier: BSD-3-Clause
"""Corridors of 2 m round a block of 8 m, each with niches of its own, and what is drawn off their walls."""
import math

from portolan_testing.room import Room, level, upright

CORNER = 5.0  # of the square that leads through the middle of the corridors [m]


def block():
    h = 4.05
    walls = [upright(h, -h, h), upright(-h, -h, h), level(h, -h, h), level(-h, -h, h)]
    walls += [level(-5.55, -3.0, -1.0), upright(5.55, 0.5, 2.0), level(5.45, 1.0, 1.9), upright(-5.35, -2.0, -0.4)]
    walls += [upright(-3.0, -6.05, -5.55), upright(2.0, 5.45, 6.05), level(3.0, 4.05, 4.45), level(-3.0, -4.5, -4.05)]
    return Room(half_side=6.05, panels=walls)


def distance(x, y, segment):
    """[m] of a point from a wall."""
    (ax, ay), (bx, by), _ = segment
    length = math.hypot(bx - ax, by - ay)
    along = max(0.0, min(length, ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / length))
    return math.hypot(x - ax - along * (bx - ax) / length, y - ay - along * (by - ay) / length)


def off_the_walls(places, room):
    """Mean distance of the places [(x, y)] from the nearest wall [m]."""
    return sum(min(distance(x, y, s) for s in room.segments) for x, y in places) / max(1, len(places))


def occupied_places(grid):
    """The middles of the grid's occupied cells."""
    side = grid.resolution
    return [((c + 0.5) * side, (r + 0.5) * side) for c, r, percent in grid.known() if percent > 65]
