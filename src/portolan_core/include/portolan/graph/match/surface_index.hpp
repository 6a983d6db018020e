// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "portolan/graph/match/surface.hpp"

namespace portolan {

/// Finds the nearest of the points whose surface has a known direction: a k-d tree.
class SurfaceIndex {
 public:
  explicit SurfaceIndex(const Surface& surface);
  SurfaceIndex(SurfaceIndex&&) noexcept;
  SurfaceIndex& operator=(SurfaceIndex&&) noexcept;
  ~SurfaceIndex();

  /// The points that have a direction; the others are left out.
  const Surface& surface() const;

  /// The index of the point of `surface()` nearest to `p`, if one is closer than `reach` [m].
  std::optional<std::size_t> nearest(const Eigen::Vector3d& p, double reach) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace portolan
