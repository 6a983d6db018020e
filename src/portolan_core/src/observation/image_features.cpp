// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/observation/image_features.hpp"

#include <algorithm>
#include <cmath>

#include "portolan/observation/limits.hpp"

namespace portolan {

bool is_usable(const ImageFeature& feature) {
  return std::abs(feature.u) <= kFurthestPixel && std::abs(feature.v) <= kFurthestPixel;
}

bool is_usable(const ImageFeatures& z) {
  const auto usable = [](const ImageFeature& feature) { return is_usable(feature); };
  return is_usable(z.camera) &&
         (z.features.empty() || std::any_of(z.features.begin(), z.features.end(), usable));
}

}  // namespace portolan
