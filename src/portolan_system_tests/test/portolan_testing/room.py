# SPDX-License-Identifier: BSD-3-Clause
"""A square room with walls that everything sees, and panels that only one kind of sensor sees."""
import math

LASER, SONAR = "laser", "sonar"
BOTH = (LASER, SONAR)

# Walls and panels stand in the middle of cells of this side, so that no rounding can move them.
RESOLUTION = 0.1  # [m]


def upright(x, y_min, y_max, seen_by=BOTH):
    """A panel at this x [m], as (point, point, who sees it)."""
    return ((x, y_min), (x, y_max), seen_by)


def level(y, x_min, x_max, seen_by=BOTH):
    """A panel at this y [m]."""
    return ((x_min, y), (x_max, y), seen_by)


class Room:
    """Segments in the plane; ranges to them are exact."""

    def __init__(self, half_side=2.05, panels=()):
        h = half_side
        self.segments = [upright(h, -h, h), upright(-h, -h, h), level(h, -h, h), level(-h, -h, h)] + list(panels)

    def distance(self, x, y, angle, sensor):
        """[m] along a ray from (x, y) to the first segment that this sensor sees; inf without one."""
        c, s = math.cos(angle), math.sin(angle)
        nearest = math.inf
        for (ax, ay), (bx, by), seen_by in self.segments:
            if sensor not in seen_by:
                continue
            ex, ey = bx - ax, by - ay
            determinant = ex * s - ey * c
            if abs(determinant) < 1e-12:
                continue
            along_ray = (ex * (ay - y) - ey * (ax - x)) / determinant
            along_segment = (c * (ay - y) - s * (ax - x)) / determinant
            if along_ray > 0.0 and 0.0 <= along_segment <= 1.0:
                nearest = min(nearest, along_ray)
        return nearest

    def scan(self, pose, beams=360):
        """Ranges all around from pose (x, y, yaw), the first beam backwards."""
        x, y, yaw = pose
        step = 2.0 * math.pi / beams
        return [self.distance(x, y, yaw - math.pi + i * step, LASER) for i in range(beams)]

    def echo(self, pose, aperture):
        """The range that a sonar hears from pose (x, y, yaw): the nearest within its cone [rad]."""
        x, y, yaw = pose
        rays = 15
        return min(self.distance(x, y, yaw + aperture * (i / (rays - 1) - 0.5), SONAR) for i in range(rays))
