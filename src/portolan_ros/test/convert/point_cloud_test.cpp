// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/convert/point_cloud.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace portolan::ros_convert {
namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;

constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();

/// How a cloud is laid out: where x, y and z stand, and what stands around them.
struct Layout {
  std::array<std::uint32_t, 3> offsets = {0, 4, 8};
  std::uint8_t datatype = PointField::FLOAT32;
  std::uint32_t point_step = 12;
  std::uint32_t row_padding = 0;
  bool is_bigendian = false;
};

template <class T>
void put(std::uint8_t* bytes, T value, bool is_bigendian) {
  std::memcpy(bytes, &value, sizeof(T));
  if (is_bigendian) std::reverse(bytes, bytes + sizeof(T));  // the tests run on little-endian hosts
}

PointCloud2 message_of(const std::vector<std::vector<Eigen::Vector3d>>& rows,
                       const Layout& layout) {
  PointCloud2 message;
  message.header.frame_id = "camera";
  message.header.stamp = ros::Time(3, 0);
  message.height = static_cast<std::uint32_t>(rows.size());
  message.width = static_cast<std::uint32_t>(rows.front().size());
  message.point_step = layout.point_step;
  message.row_step = message.width * layout.point_step + layout.row_padding;
  message.is_bigendian = layout.is_bigendian;
  message.data.assign(std::size_t{message.row_step} * message.height, 0x7f);
  const char* const names[] = {"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) {
    PointField field;
    field.name = names[i];
    field.offset = layout.offsets[i];
    field.datatype = layout.datatype;
    field.count = 1;
    message.fields.push_back(field);
  }
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (std::size_t column = 0; column < rows[row].size(); ++column) {
      std::uint8_t* point =
          message.data.data() + row * message.row_step + column * layout.point_step;
      for (std::size_t i = 0; i < 3; ++i) {
        const double value = rows[row][column][static_cast<Eigen::Index>(i)];
        if (layout.datatype == PointField::FLOAT64) {
          put(point + layout.offsets[i], value, layout.is_bigendian);
        } else {
          put(point + layout.offsets[i], static_cast<float>(value), layout.is_bigendian);
        }
      }
    }
  }
  return message;
}

const std::vector<std::vector<Eigen::Vector3d>> kRows = {{{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}},
                                                         {{-1.0, 0.5, 0.0}, {7.0, 8.0, -9.0}}};

PointCloud2 good() { return message_of(kRows, {}); }

TEST(PointCloudMessage, GivesItsPointsFrameAndTime) {
  const auto sensed = point_cloud(good());
  ASSERT_TRUE(sensed);
  EXPECT_EQ(sensed->frame, "camera");
  EXPECT_EQ(sensed->first, Time(seconds(3.0)));
  EXPECT_EQ(sensed->last, sensed->first);
  ASSERT_EQ(sensed->z.points.size(), 4u);
  EXPECT_EQ(sensed->z.points[1], Eigen::Vector3f(4.0F, 5.0F, 6.0F));
  EXPECT_EQ(sensed->z.points[2], Eigen::Vector3f(-1.0F, 0.5F, 0.0F));
  EXPECT_TRUE(sensed->z.no_returns.empty());
}

TEST(PointCloudMessage, MayBeLaidOutInAnyWay) {
  const auto expected = point_cloud(good())->z.points;
  for (const bool is_bigendian : {false, true}) {
    for (const std::uint32_t padding : {0u, 5u}) {
      for (const std::uint32_t gap : {0u, 3u}) {  // so that no number is aligned
        const Layout floats{
            {gap, gap + 8, gap + 4}, PointField::FLOAT32, 32, padding, is_bigendian};
        const Layout doubles{
            {gap + 16, gap, gap + 8}, PointField::FLOAT64, 29, padding, is_bigendian};
        for (const Layout& layout : {floats, doubles}) {
          const auto sensed = point_cloud(message_of(kRows, layout));
          ASSERT_TRUE(sensed);
          EXPECT_EQ(sensed->z.points, expected);
        }
      }
    }
  }
}

TEST(PointCloudMessage, LosesPointsThatAreNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const std::vector<std::vector<Eigen::Vector3d>> rows = {
      {{nan, nan, nan}, {1.0, 2.0, 3.0}, {1.0, inf, 3.0}, {1.0, 2.0, -inf}, {nan, 2.0, 3.0}}};
  const auto sensed = point_cloud(message_of(rows, {}));
  ASSERT_TRUE(sensed);
  ASSERT_EQ(sensed->z.points.size(), 1u);
  EXPECT_EQ(sensed->z.points[0], Eigen::Vector3f(1.0F, 2.0F, 3.0F));
}

TEST(PointCloudMessage, MayBeEmpty) {
  PointCloud2 message = good();
  message.width = message.row_step = 0;
  message.data.clear();
  ASSERT_TRUE(point_cloud(message));
  EXPECT_TRUE(point_cloud(message)->z.points.empty());
  message.height = kMost;  // as many rows of nothing
  EXPECT_TRUE(point_cloud(message)->z.points.empty());
  message.height = 0;
  message.width = kMost;
  EXPECT_TRUE(point_cloud(message)->z.points.empty());
}

TEST(PointCloudMessage, TheLastRowNeedsNoPadding) {
  PointCloud2 message = message_of(kRows, {{0, 4, 8}, PointField::FLOAT32, 12, 5, false});
  message.data.resize(message.data.size() - 5);
  EXPECT_TRUE(point_cloud(message));
  message.data.pop_back();
  EXPECT_FALSE(point_cloud(message));
}

// Each of these would read beyond the data, or ask for memory that nobody has.
TEST(PointCloudMessage, ThatIsMalformedIsNone) {
  const std::vector<std::function<void(PointCloud2&)>> spoil = {
      [](PointCloud2& m) { m.data.pop_back(); },
      [](PointCloud2& m) { m.data.clear(); },
      [](PointCloud2& m) { m.width = kMost; },
      [](PointCloud2& m) { m.height = kMost; },
      [](PointCloud2& m) { m.width = m.height = kMost; },
      [](PointCloud2& m) { m.width = m.height = m.row_step = m.point_step = kMost; },
      [](PointCloud2& m) { m.width = m.height = 65536, m.row_step = 0; },
      [](PointCloud2& m) { m.width = 0x80000000u, m.point_step = 16, m.row_step = 0; },
      [](PointCloud2& m) { m.point_step = 0; },
      [](PointCloud2& m) { m.point_step = 11; },
      [](PointCloud2& m) { m.point_step = kMost; },
      [](PointCloud2& m) { m.row_step = 23; },
      [](PointCloud2& m) { m.row_step = 0; },
      [](PointCloud2& m) { m.row_step = kMost; },
      [](PointCloud2& m) { m.fields[2].offset = 9; },
      [](PointCloud2& m) { m.fields[0].offset = kMost; },
      [](PointCloud2& m) { m.fields[0].offset = kMost - 3; },
      [](PointCloud2& m) { m.fields[0].datatype = PointField::INT32; },
      [](PointCloud2& m) { m.fields[0].datatype = PointField::FLOAT64, m.fields[0].offset = 8; },
      [](PointCloud2& m) { m.fields[1].datatype = 0; },
      [](PointCloud2& m) { m.fields[1].name = "Y"; },
      [](PointCloud2& m) { m.fields.pop_back(); },
      [](PointCloud2& m) { m.fields.clear(); },
  };
  for (std::size_t i = 0; i < spoil.size(); ++i) {
    PointCloud2 message = good();
    spoil[i](message);
    EXPECT_FALSE(point_cloud(message)) << i;
  }
  EXPECT_FALSE(point_cloud(PointCloud2()));
}

TEST(OrganizedCloudMessage, SaysWhereNothingCameBack) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::vector<Eigen::Vector3d>> rows(5);
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 6; ++column) {
      rows[static_cast<std::size_t>(row)].emplace_back(0.2 * column - 0.5, 0.2 * row - 0.4, 1.0);
    }
  }
  const auto as_direction = [](const Eigen::Vector3d& p) -> Eigen::Vector3f {
    return p.normalized().cast<float>();
  };
  const Eigen::Vector3f silent = as_direction(rows[2][3]);
  const Eigen::Vector3f failed = as_direction(rows[1][4]);
  const double inf = std::numeric_limits<double>::infinity();
  rows[2][3] = {inf, nan, inf};  // depth_image_proc multiplies the depth, in the middle row by 0
  rows[1][4] = {nan, nan, nan};
  rows[1][1] = {inf, inf, -inf};  // too near
  const auto sensed = organized_cloud(message_of(rows, {}));
  ASSERT_TRUE(sensed);
  const PointCloud& cloud = sensed->z.cloud;
  EXPECT_EQ(cloud.points.size(), 27u);
  ASSERT_EQ(cloud.no_returns.size(), 1u);
  EXPECT_TRUE(cloud.no_returns[0].isApprox(silent, 1e-5F));
  ASSERT_EQ(sensed->z.unknown.size(), 1u);
  EXPECT_TRUE(sensed->z.unknown[0].isApprox(failed, 1e-5F));
  EXPECT_TRUE(point_cloud(message_of(rows, {}))->z.no_returns.empty());
  EXPECT_FALSE(organized_cloud(PointCloud2()));
}

}  // namespace
}  // namespace portolan::ros_convert
