// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "portolan/graph/keyframe.hpp"
#include "portolan/graph/match/scan_surface.hpp"

namespace portolan {

/// A scan and where its sensor stood.
struct View {
  const RangeScan* scan = nullptr;
  Pose T_map_sensor = Pose::Identity();
};

/// What a few keyframes saw, put together: a patch of map that is matched as one.
struct LocalMap {
  std::vector<View> views;
  Surface surface;  // flat: z = 0
};

/// Puts keyframes together at their poses in one frame; of surfaces seen twice the first counts.
/// The plane of the map is the frame's xy plane.
class LocalMapMaker {
 public:
  explicit LocalMapMaker(const SurfaceOptions& options) : options_(options) {}

  /// A keyframe over 200 m away is left out: a false arc bent the graph apart there.
  /// One whose scan was given up adds nothing.
  void add(const Keyframe& keyframe, const Pose& T_map_base);
  LocalMap make() &&;

 private:
  SurfaceOptions options_;
  LocalMap map_;
};

/// Whether two views of a place speak of the same one, by what each beam should see of the other's
/// surfaces: on a surface it agrees, through it is a contradiction, in front of it says nothing.
struct Agreement {
  double shared = 0.0;  ///< share of the second one's points that the first could see
  double agreed = 0.0;  ///< of both, share of those that were seen where they are
};

/// Of the surfaces of both in the views of the other; `margin` [m] is the difference allowed.
Agreement agreement(const LocalMap& a, const LocalMap& b, const Pose& T_a_b, double margin);

}  // namespace portolan
