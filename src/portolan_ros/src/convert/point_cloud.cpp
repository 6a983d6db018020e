// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/convert/point_cloud.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "portolan/observation/missing_directions.hpp"
#include "portolan_ros/convert/basics.hpp"

namespace portolan::ros_convert {

namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;

/// Reads one coordinate of a point, whatever its width and byte order.
struct Coordinate {
  std::uint32_t offset;
  bool is_double;
  bool is_swapped;

  template <class T>
  T load(const std::uint8_t* bytes) const {
    std::array<std::uint8_t, sizeof(T)> raw;
    std::memcpy(raw.data(), bytes, sizeof(T));
    if (is_swapped) std::reverse(raw.begin(), raw.end());
    T value;
    std::memcpy(&value, raw.data(), sizeof(T));
    return value;
  }

  float operator()(const std::uint8_t* point) const {
    return is_double ? static_cast<float>(load<double>(point + offset))
                     : load<float>(point + offset);
  }
};

bool host_is_big_endian() {
  const std::uint16_t one = 1;
  std::uint8_t first = 0;
  std::memcpy(&first, &one, 1);
  return first == 0;
}

std::optional<Coordinate> coordinate(const PointCloud2& message, const std::string& name) {
  for (const PointField& field : message.fields) {
    if (field.name != name) continue;
    const bool is_double = field.datatype == PointField::FLOAT64;
    if (!is_double && field.datatype != PointField::FLOAT32) return std::nullopt;
    const std::uint64_t end = std::uint64_t{field.offset} + (is_double ? 8 : 4);
    if (end > message.point_step) return std::nullopt;
    return Coordinate{field.offset, is_double, message.is_bigendian != host_is_big_endian()};
  }
  return std::nullopt;
}

bool is_empty(const PointCloud2& message) { return message.width == 0 || message.height == 0; }

/// So there are no more points than bytes of data: no size can make us ask for absurd memory.
bool sizes_fit(const PointCloud2& message) {
  const std::uint64_t row = std::uint64_t{message.width} * message.point_step;
  if (is_empty(message)) return true;
  return row <= message.row_step &&
         std::uint64_t{message.row_step} * (message.height - 1) + row <= message.data.size();
}

/// Each place's point, finite or not.
std::optional<Sensed<PointCloud>> all_points(const PointCloud2& message) {
  const auto x = coordinate(message, "x");
  const auto y = coordinate(message, "y");
  const auto z = coordinate(message, "z");
  if (!x || !y || !z || !sizes_fit(message)) return std::nullopt;
  const std::size_t height = is_empty(message) ? 0 : message.height;
  PointCloud cloud;
  cloud.points.reserve(message.width * height);
  for (std::size_t row = 0; row < height; ++row) {
    const std::uint8_t* point = message.data.data() + row * message.row_step;
    for (std::size_t column = 0; column < message.width; ++column, point += message.point_step) {
      cloud.points.emplace_back((*x)(point), (*y)(point), (*z)(point));
    }
  }
  const Time stamp = time(message.header.stamp);
  return Sensed<PointCloud>{message.header.frame_id, stamp, stamp, std::move(cloud)};
}

void drop_not_finite(std::vector<Eigen::Vector3f>& points) {
  points.erase(std::remove_if(points.begin(), points.end(),
                              [](const Eigen::Vector3f& p) { return !p.allFinite(); }),
               points.end());
}

}  // namespace

std::optional<Sensed<PointCloud>> point_cloud(const PointCloud2& message) {
  auto sensed = all_points(message);
  if (sensed) drop_not_finite(sensed->z.points);
  return sensed;
}

std::optional<Sensed<OrganizedCloud>> organized_cloud(const PointCloud2& message) {
  auto sensed = all_points(message);
  if (!sensed) return std::nullopt;
  OrganizedCloud organized;
  if (message.height > 1) {
    MissingDirections missing = missing_directions(sensed->z.points, message.width);
    organized.cloud.no_returns = std::move(missing.nothing_returned);
    organized.unknown = std::move(missing.unknown);
  }
  organized.cloud.points = std::move(sensed->z.points);
  drop_not_finite(organized.cloud.points);
  return Sensed<OrganizedCloud>{sensed->frame, sensed->first, sensed->last, std::move(organized)};
}

}  // namespace portolan::ros_convert
