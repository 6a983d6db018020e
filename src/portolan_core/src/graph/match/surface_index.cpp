// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/match/surface_index.hpp"

#include <nanoflann.hpp>

namespace portolan {

namespace {

// What nanoflann wants to know of the points.
struct Points {
  explicit Points(const Surface& all) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!all.normals[i].isZero(0.0)) surface.add(all.points[i], all.normals[i]);
    }
  }
  std::size_t kdtree_get_point_count() const { return surface.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return surface.points[i][static_cast<Eigen::Index>(axis)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;
  }

  Surface surface;
};

using KdTree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Points>, Points, 3>;

// The result set of a search for one point within a distance.
class Nearest {
 public:
  using DistanceType = double;

  explicit Nearest(double reach) : squared_(reach * reach) {}
  bool addPoint(double squared, std::size_t index) {  // NOLINT(readability-identifier-naming)
    if (squared < squared_) {
      squared_ = squared;
      index_ = index;
    }
    return true;
  }
  double worstDist() const { return squared_; }  // NOLINT(readability-identifier-naming)
  bool full() const { return true; }
  std::size_t size() const { return index_ ? 1 : 0; }
  std::optional<std::size_t> index() const { return index_; }

 private:
  double squared_;
  std::optional<std::size_t> index_;
};

}  // namespace

struct SurfaceIndex::Tree {
  explicit Tree(const Surface& surface)
      : points(surface), tree(3, points, nanoflann::KDTreeSingleIndexAdaptorParams(8)) {
    tree.buildIndex();
  }
  Points points;
  KdTree tree;
};

SurfaceIndex::SurfaceIndex(const Surface& surface) : tree_(std::make_unique<Tree>(surface)) {}
SurfaceIndex::SurfaceIndex(SurfaceIndex&&) noexcept = default;
SurfaceIndex& SurfaceIndex::operator=(SurfaceIndex&&) noexcept = default;
SurfaceIndex::~SurfaceIndex() = default;

const Surface& SurfaceIndex::surface() const { return tree_->points.surface; }

std::optional<std::size_t> SurfaceIndex::nearest(const Eigen::Vector3d& p, double reach) const {
  if (surface().empty()) return std::nullopt;
  Nearest result(reach);
  tree_->tree.findNeighbors(result, p.data(), {});
  return result.index();
}

}  // namespace portolan
