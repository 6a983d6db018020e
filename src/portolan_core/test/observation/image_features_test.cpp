// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/observation/image_features.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace portolan {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

const PinholeCamera kCamera{300.0, 310.0, 320.0, 240.0};

TEST(ImageFeatures, NeedACameraThatDraws) {
  EXPECT_TRUE(is_usable(ImageFeatures{kCamera, {}}));
  EXPECT_FALSE(is_usable(ImageFeatures{}));
  PinholeCamera mirrored = kCamera;
  mirrored.fx = -300.0;
  EXPECT_FALSE(is_usable(mirrored));
  PinholeCamera lost = kCamera;
  lost.cy = kNan;
  EXPECT_FALSE(is_usable(lost));
}

TEST(ImageFeatures, AreUsableUnlessAllAreMalformed) {
  ImageFeatures z{kCamera, {{1, 10.0, 20.0}, {ImageFeature::kUnknown, -3.0, 20.5}}};
  EXPECT_TRUE(is_usable(z));
  z.features[0].v = kNan;
  EXPECT_TRUE(is_usable(z));
  z.features[1].u = kNan;
  EXPECT_FALSE(is_usable(z));
}

TEST(ImageFeatures, ByteSizeGrowsWithTheirNumber) {
  ImageFeatures z;
  const std::size_t empty = byte_size(z);
  z.features.resize(10);
  EXPECT_GE(byte_size(z), empty + 10 * sizeof(ImageFeature));
}

}  // namespace
}  // namespace portolan
