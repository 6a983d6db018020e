# SPDX-License-Identifier: BSD-3-Clause
"""A square hall as a sensor of points sees it: four walls, each point in the middle of a voxel."""
import math

RESOLUTION = 0.1  # [m]
HALF_SIDE = 2.05  # of the hall [m]
HEIGHTS = [round(-0.35 + 0.1 * i, 2) for i in range(10)]  # of points, against the sensor [m]


def walls():
    """The points of all walls in the hall's own frame."""
    along = [round(-1.95 + 0.1 * i, 2) for i in range(40)]
    sides = [(s * HALF_SIDE, a) for s in (-1, 1) for a in along] + [(a, s * HALF_SIDE) for s in (-1, 1) for a in along]
    return [(x, y, z) for x, y in sides for z in HEIGHTS]


def seen_from(pose, points=None):
    """The points as a sensor at pose (x, y, yaw) sees them."""
    x, y, yaw = pose
    c, s = math.cos(yaw), math.sin(yaw)
    return [(c * (px - x) + s * (py - y), c * (py - y) - s * (px - x), pz) for px, py, pz in points or walls()]
