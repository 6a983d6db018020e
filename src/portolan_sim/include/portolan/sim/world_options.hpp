// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "portolan/options.hpp"
#include "portolan/sim/material.hpp"

namespace portolan::sim {

/// A world as it stands in a file: what is solid, what can be recognised, where to drive.
struct WorldOptions {
  using Point = std::vector<double>;  // as YAML has it: [x, y] or [x, y, z]

  /// A wall along a line of points.
  struct Wall {
    std::vector<Point> points;
    double thickness = 0.1;
    double bottom = 0.0;
    double height = 2.5;
    Material material = Material::ordinary;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor& visit) {
      visit("points", self.points, "[x, y] of each corner along the wall [m]");
      visit("thickness", self.thickness, "from face to face [m]", above(0.0));
      visit("bottom", self.bottom, "height of the lower edge [m]");
      visit("height", self.height, "from lower to upper edge [m]", above(0.0));
      visit("material", self.material, "what it is made of");
      visit.require(self.points.size() >= 2, "points: a wall needs two or more");
      visit.require(have_size(self.points, 2), "points: each must be [x, y]");
    }
  };

  /// A block that stands or hangs.
  struct Box {
    Point center = {0.0, 0.0};
    Point size = {1.0, 1.0};
    double yaw = 0.0;
    double bottom = 0.0;
    double height = 1.0;
    Material material = Material::ordinary;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor& visit) {
      visit("center", self.center, "[x, y] of its middle [m]");
      visit("size", self.size, "[length, width] [m]", above(0.0));
      visit("yaw", self.yaw, "of its length from the x axis [rad]");
      visit("bottom", self.bottom, "height of the lower face [m]");
      visit("height", self.height, "from lower to upper face [m]", above(0.0));
      visit("material", self.material, "what it is made of");
      visit.require(self.center.size() == 2, "center must be [x, y]");
      visit.require(self.size.size() == 2, "size must be [length, width]");
    }
  };

  /// A pillar, a plant, the leg of a table.
  struct Cylinder {
    Point center = {0.0, 0.0};
    double radius = 0.2;
    double bottom = 0.0;
    double height = 2.5;
    Material material = Material::ordinary;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor& visit) {
      visit("center", self.center, "[x, y] of its axis [m]");
      visit("radius", self.radius, "[m]", above(0.0));
      visit("bottom", self.bottom, "height of the lower face [m]");
      visit("height", self.height, "from lower to upper face [m]", above(0.0));
      visit("material", self.material, "what it is made of");
      visit.require(self.center.size() == 2, "center must be [x, y]");
    }
  };

  /// A landmark or a beacon: a point with a name.
  struct Mark {
    int id = 0;
    Point position = {0.0, 0.0, 0.0};

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor& visit) {
      visit("id", self.id, "identity", at_least(0));
      visit("position", self.position, "[x, y, z] [m]");
      visit.require(self.position.size() == 3, "position must be [x, y, z]");
    }
  };

  std::vector<Wall> walls;
  std::vector<Box> boxes;
  std::vector<Cylinder> cylinders;
  std::vector<Mark> landmarks;
  std::vector<Mark> beacons;
  bool floor = true;
  double ceiling = 0.0;
  Point start = {0.0, 0.0, 0.0};
  std::vector<Point> tour;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("walls", self.walls, "walls, each along a line of points");
    visit("boxes", self.boxes, "blocks");
    visit("cylinders", self.cylinders, "round things");
    visit("landmarks", self.landmarks, "points that sensors can recognise");
    visit("beacons", self.beacons, "transmitters that answer with their distance");
    visit("floor", self.floor, "a floor at height 0 that light and sound meet");
    visit("ceiling", self.ceiling, "height of the ceiling; 0: none [m]", at_least(0.0));
    visit("start", self.start, "[x, y, yaw] where a robot starts that follows no path [m, rad]");
    visit("tour", self.tour, "[x, y] points of a path that sees it all without a collision [m]");
    visit.require(self.start.size() == 3, "start must be [x, y, yaw]");
    visit.require(have_size(self.tour, 2), "tour: each point must be [x, y]");
  }

  /// True where each point has so many coordinates.
  static bool have_size(const std::vector<Point>& points, std::size_t size) {
    for (const Point& point : points) {
      if (point.size() != size) return false;
    }
    return true;
  }
};

}  // namespace portolan::sim
