// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/keyframe_maps.hpp"

#include <cmath>
#include <utility>

namespace portolan {

LocalMap PlacedKeyframes::map_around(std::size_t i, double way_before, double way_after,
                                     const SurfaceOptions& options) const {
  const double here = keyframes[i].travelled;
  LocalMapMaker maker(options);
  const auto add = [&](std::size_t k) { maker.add(keyframes[k], between(i, k)); };
  add(i);
  for (std::size_t k = i; k > 0 && here - keyframes[k - 1].travelled <= way_before; --k) add(k - 1);
  for (std::size_t k = i + 1; k < keyframes.size() && keyframes[k].travelled - here <= way_after;
       ++k) {
    add(k);
  }
  return std::move(maker).make();
}

std::size_t PlacedKeyframes::nearest(const Pose& T_map, std::size_t around, double way) const {
  std::size_t best = around;
  const auto distance = [&](std::size_t i) {
    return (T_map_base(i).translation() - T_map.translation()).norm();
  };
  for (std::size_t i = 0; i + 1 < keyframes.size(); ++i) {
    const double apart = std::abs(keyframes[i].travelled - keyframes[around].travelled);
    if (apart <= way && distance(i) < distance(best)) best = i;
  }
  return best;
}

}  // namespace portolan
