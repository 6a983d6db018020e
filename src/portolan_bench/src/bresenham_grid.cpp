// SPDX-License-Identifier: BSD-3-Clause
#include "bresenham_grid.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace portolan::bench {

namespace {

/// The grid that everybody writes first: an array, a line of cells per beam, saturating bytes.
class BresenhamGrid {
 public:
  explicit BresenhamGrid(const Eigen::AlignedBox2d& extent)
      : low_(extent.min()),
        width_(cell(extent.sizes().x()) + 1),
        cells_(static_cast<std::size_t>(width_ * (cell(extent.sizes().y()) + 1))) {}

  void insert(const RangeScan& scan, const Pose& T_map_sensor) {
    const double heading = yaw(T_map_sensor);
    const Eigen::Vector2d p = T_map_sensor.translation().head<2>() - low_;
    for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
      const double range = static_cast<double>(scan.ranges[i]);
      if (range_reading(range, scan.range_min, scan.range_max) != RangeReading::hit) continue;
      const double angle = heading + scan.angle_min + static_cast<double>(i) * scan.angle_increment;
      line(cell(p.x()), cell(p.y()), cell(p.x() + range * std::cos(angle)),
           cell(p.y() + range * std::sin(angle)));
    }
  }

 private:
  static int cell(double metres) { return static_cast<int>(std::floor(metres / 0.05)); }

  void line(int x, int y, int x_end, int y_end) {
    const int dx = std::abs(x_end - x), dy = -std::abs(y_end - y);
    const int step_x = x < x_end ? 1 : -1, step_y = y < y_end ? 1 : -1;
    int error = dx + dy;
    while (x != x_end || y != y_end) {
      add(x, y, -22);
      const int twice = 2 * error;
      if (twice >= dy) error += dy, x += step_x;
      if (twice <= dx) error += dx, y += step_y;
    }
    add(x, y, 22);
  }

  void add(int x, int y, int step) {
    std::int8_t& cell = cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                               static_cast<std::size_t>(x)];
    cell = static_cast<std::int8_t>(std::clamp(cell + step, -78, 78));
  }

  Eigen::Vector2d low_;
  int width_;
  std::vector<std::int8_t> cells_;
};

}  // namespace

Drawer bresenham_grid(const Workload& workload) {
  auto map = std::make_shared<BresenhamGrid>(workload.extent());
  return [map, &workload](std::size_t i) {
    const Workload::Reading& reading = workload.readings[i];
    map->insert(std::get<RangeScan>(reading.z), reading.T_map_sensor);
  };
}

}  // namespace portolan::bench
