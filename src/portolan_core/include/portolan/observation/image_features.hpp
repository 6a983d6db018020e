// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "portolan/observation/pinhole_camera.hpp"
#include "portolan/pose_covariance.hpp"

namespace portolan {

/// One feature in a rectified image.
struct ImageFeature {
  static constexpr std::int32_t kUnknown = -1;

  std::int32_t id = kUnknown;  ///< identity, where the tracker keeps one
  double u = 0.0;              ///< column, the centre of the left one is 0 [pixel]
  double v = 0.0;              ///< row, the centre of the top one is 0 [pixel]
};

/// The features that one camera saw in one moment, and how that camera draws. The sensor's frame
/// is the optical one: x right, y down, z forward.
struct ImageFeatures {
  PinholeCamera camera;
  std::vector<ImageFeature> features;
  /// Of the sensor's pose, along and about the sensor's own axes, where anybody stated it.
  std::optional<PoseCovariance> pose_covariance = std::nullopt;
};

/// True where both pixels are finite and within the limits of `limits.hpp`.
bool is_usable(const ImageFeature& feature);

/// True where the camera is usable and not every feature is malformed.
bool is_usable(const ImageFeatures& z);

/// What it occupies in memory [byte].
inline std::size_t byte_size(const ImageFeatures& z) {
  return sizeof(z) + z.features.capacity() * sizeof(ImageFeature);
}

}  // namespace portolan
