// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/kinds/octo_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace portolan {

namespace {

constexpr Picture::Colour kUnknown{205, 205, 205};
constexpr Picture::Colour kBorder{120, 120, 120};
constexpr Picture::Colour kWay{200, 60, 40};
constexpr int kMostPixels = 4000;  // along a side
constexpr int kGoodPixels = 1000;  // likewise, for small maps

/// The voxels between two corners.
struct Box {
  std::array<int, 3> low = {VoxelLattice::kSide, VoxelLattice::kSide, VoxelLattice::kSide};
  std::array<int, 3> high = {0, 0, 0};

  void extend(BlockKey key) {
    const std::array<int, 3> corner = {8 * key.x, 8 * key.y, 8 * key.z};
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], corner[i]);
      high[i] = std::max(high[i], corner[i] + 8);
    }
  }
  int side(std::size_t axis) const { return high[axis] - low[axis]; }
};

/// One view along an axis: x to the right, `up` upwards, and how many voxels a pixel spans.
class View {
 public:
  View(const Box& box, std::size_t up, int voxels_per_pixel)
      : box_(box),
        up_(up),
        span_(voxels_per_pixel),
        width_((box.side(0) + span_ - 1) / span_),
        height_((box.side(up) + span_ - 1) / span_),
        known_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), false),
        occupied_(known_.size(), 0) {}

  void add(const std::array<int, 3>& voxel, bool is_occupied) {
    const int row = (box_.high[up_] - 1 - voxel[up_]) / span_;
    const int pixel = row * width_ + (voxel[0] - box_.low[0]) / span_;
    const auto i = static_cast<std::size_t>(pixel);
    known_[i] = true;
    if (is_occupied) ++occupied_[i];
  }

  /// Draws the view into a picture, from this row on.
  void draw(Picture& picture, int first_row) const {
    const std::uint32_t most = *std::max_element(occupied_.begin(), occupied_.end());
    for (int i = 0; i < width_ * height_; ++i) {
      picture.set(i % width_, first_row + i / width_, colour(static_cast<std::size_t>(i), most));
    }
  }

  /// Where a point of the map lies in the view, in pixels.
  std::array<double, 2> pixel(const Eigen::Vector3d& p_map, double resolution) const {
    const auto place = [&](std::size_t axis) {
      return p_map[static_cast<Eigen::Index>(axis)] / resolution + VoxelLattice::kMiddle;
    };
    return {(place(0) - box_.low[0]) / span_, (box_.high[up_] - place(up_)) / span_};
  }

  int width() const { return width_; }
  int height() const { return height_; }

 private:
  Picture::Colour colour(std::size_t i, std::uint32_t most) const {
    if (!known_[i]) return kUnknown;
    if (occupied_[i] == 0) return {254, 254, 254};
    const double share = std::sqrt(static_cast<double>(occupied_[i]) / most);
    const auto part = [share](double lightest) {
      return static_cast<std::uint8_t>(std::lround(lightest * (1.0 - share)));
    };
    return {part(185.0), part(208.0), static_cast<std::uint8_t>(50 + part(190.0))};
  }

  Box box_;
  std::size_t up_;
  int span_;
  int width_;
  int height_;
  std::vector<bool> known_;
  std::vector<std::uint32_t> occupied_;
};

Box bounds(const OctoMapper& map) {
  Box box;
  map.blocks().for_each([&](BlockKey key, const VoxelBlock& /*block*/) { box.extend(key); });
  return box;
}

void look_at(const OctoMapper& map, View& plan, View& elevation) {
  map.blocks().for_each([&](BlockKey key, const VoxelBlock& block) {
    const VoxelMask mask = occupied(block, map.threshold_log_odds());
    for (std::size_t i = 0; i < block.log_odds.size(); ++i) {
      if (!block.is_known(i)) continue;
      const auto place = static_cast<int>(i);
      const std::array<int, 3> voxel = {8 * key.x + place % 8, 8 * key.y + place / 8 % 8,
                                        8 * key.z + place / 64};
      const bool is_occupied = ((mask[i / 64] >> (i % 64)) & 1) != 0;
      plan.add(voxel, is_occupied);
      elevation.add(voxel, is_occupied);
    }
  });
}

void draw_way(Picture& picture, const View& plan, double resolution,
              const std::vector<Pose>& T_map_base) {
  const double factor = static_cast<double>(picture.width()) / plan.width();
  for (std::size_t i = 1; i < T_map_base.size(); ++i) {
    const auto a = plan.pixel(T_map_base[i - 1].translation(), resolution);
    const auto b = plan.pixel(T_map_base[i].translation(), resolution);
    picture.line(factor * a[0], factor * a[1], factor * b[0], factor * b[1], kWay);
  }
}

}  // namespace

Picture octo_picture(const OctoMapper& map, const std::vector<Pose>& T_map_base) {
  const Box box = bounds(map);
  const int longest = std::max({box.side(0), box.side(1), box.side(2)});
  const int span = (longest + kMostPixels - 1) / kMostPixels;
  View plan(box, 1, span);
  View elevation(box, 2, span);
  look_at(map, plan, elevation);
  constexpr int kGap = 2;  // rows between the views
  Picture picture(static_cast<std::size_t>(plan.width()),
                  static_cast<std::size_t>(plan.height() + kGap + elevation.height()), kBorder);
  plan.draw(picture, 0);
  elevation.draw(picture, plan.height() + kGap);
  picture = picture.enlarged(static_cast<std::size_t>(std::max(1, kGoodPixels / longest)));
  draw_way(picture, plan, map.lattice().resolution(), T_map_base);
  return picture;
}

}  // namespace portolan
