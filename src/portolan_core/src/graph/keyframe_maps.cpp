// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/keyframe_maps.hpp"

#include <cmath>
#include <set>
#include <utility>

namespace portolan {

namespace {

// Tells each square from the others once.
class Places {
 public:
  explicit Places(double side) : side_(side) {}

  bool is_new(const Pose& T) { return taken_.insert(square_of(T, side_)).second; }

 private:
  double side_;
  std::set<Square> taken_;
};

}  // namespace

Square square_of(const Pose& T_map_base, double side) {
  const Eigen::Vector3d p = T_map_base.translation() / side;
  return {std::floor(p.x()), std::floor(p.y()), std::floor(yaw(T_map_base) / M_PI_2)};
}

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

LocalMap PlacedKeyframes::map_near(std::size_t i, std::size_t end, double distance,
                                   const SurfaceOptions& options) const {
  const auto is_near = [&](std::size_t k) {
    return (T_map_base(k).translation() - T_map_base(i).translation()).norm() <= distance;
  };
  Places places(1.0);
  LocalMapMaker maker(options);
  maker.add(keyframes[i], Pose::Identity());
  for (std::size_t k = 0; k < end; ++k) {
    if (keyframes[k].scan.ranges.empty() || !is_near(k)) continue;
    if (k != i && places.is_new(T_map_base(k))) maker.add(keyframes[k], between(i, k));
  }
  return std::move(maker).make();
}

std::vector<std::size_t> PlacedKeyframes::places(std::size_t end, double side) const {
  Places places(side);
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < end; ++k) {
    if (!keyframes[k].scan.ranges.empty() && places.is_new(T_map_base(k))) found.push_back(k);
  }
  return found;
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

std::size_t PlacedKeyframes::nearest(const Pose& T_map, std::size_t end) const {
  std::size_t best = end;
  const auto distance = [&](std::size_t i) {
    return (T_map_base(i).translation() - T_map.translation()).norm();
  };
  for (std::size_t i = 0; i < end; ++i) {
    if (keyframes[i].scan.ranges.empty()) continue;
    if (best == end || distance(i) < distance(best)) best = i;
  }
  return best;
}

}  // namespace portolan
