// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/kinds/cell_markers.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <tuple>

#include "octo_maps.hpp"

namespace portolan {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

/// What rviz shows after all messages so far.
class Screen {
 public:
  void take(const MarkerArray& message) {
    for (const Marker& marker : message.markers) {
      if (marker.action == Marker::DELETEALL) markers_.clear();
      if (marker.action == Marker::DELETE) markers_.erase(marker.id);
      if (marker.action == Marker::ADD) markers_[marker.id] = marker;
    }
  }

  std::multiset<std::tuple<double, double, double>> cubes() const {
    std::multiset<std::tuple<double, double, double>> cubes;
    for (const auto& [id, marker] : markers_) {
      EXPECT_EQ(marker.type, Marker::CUBE_LIST);
      EXPECT_EQ(marker.points.size(), marker.colors.size());
      for (const auto& p : marker.points) cubes.emplace(p.x, p.y, p.z);
    }
    return cubes;
  }

 private:
  std::map<int, Marker> markers_;
};

std::multiset<std::tuple<double, double, double>> occupied_of(const OctoMapper& map,
                                                              const Shown& shown) {
  std::multiset<std::tuple<double, double, double>> cubes;
  for (const octomap::OcTreeKey& key : occupied_voxels(map, shown)) {
    const VoxelLattice& lattice = map.lattice();
    cubes.emplace(lattice.centre(key[0]), lattice.centre(key[1]), lattice.centre(key[2]));
  }
  return cubes;
}

TEST(CellMarkers, ShowEveryOccupiedVoxelOnceAfterEachChange) {
  for (const Shown& shown : {Shown{}, Shown{{-1.0, 0.5}}, Shown{{}, true}}) {
    OctoMapper map(octo_options());
    CellMarkers markers(shown, 3.0);
    Screen screen;
    for (unsigned i = 0; i < 12; ++i) {
      map.insert(octo_cloud(i, 60), planar_pose(1.5 * i, 0.0, 0.1));
      screen.take(markers.changes(map, 0));
      ASSERT_EQ(screen.cubes(), occupied_of(map, shown)) << i;
    }
    EXPECT_GT(screen.cubes().size(), 50u);
  }
}

TEST(CellMarkers, SendAgainOnlyWhatChanged) {
  OctoMapper map(octo_options());
  CellMarkers markers(Shown{}, 3.0);
  for (unsigned i = 0; i < 10; ++i) map.insert(octo_cloud(i), planar_pose(20.0 * i, 0.0, 0.0));
  const std::size_t all = markers.changes(map, 0).markers.size();
  EXPECT_TRUE(markers.changes(map, 0).markers.empty());
  map.insert(octo_cloud(11), planar_pose(100.0, 0.0, 0.0));
  const std::size_t few = markers.changes(map, 0).markers.size();
  EXPECT_GT(few, 0u);
  EXPECT_LT(few, all / 3);
  markers.forget();
  EXPECT_GE(markers.changes(map, 0).markers.size(), all);
}

TEST(CellMarkers, TakeAwayCubesThatBecomeFree) {
  OctoMapper map(octo_options());
  CellMarkers markers(Shown{}, 3.0);
  Screen screen;
  map.insert(octo_cloud(1), Pose::Identity());
  screen.take(markers.changes(map, 0));
  ASSERT_FALSE(screen.cubes().empty());
  const Eigen::Vector3d corner(9.0, 9.0, 9.0);
  map.insert(ClearBox{{-corner, corner}}, Pose::Identity());
  screen.take(markers.changes(map, 0));
  EXPECT_TRUE(screen.cubes().empty());
}

TEST(CellMarkers, BeginAnewWithAnotherMap) {
  CellMarkers markers(Shown{}, 3.0);
  Screen screen;
  screen.take(markers.changes(octo_map(1), 0));
  const OctoMapper other = octo_map(2);
  screen.take(markers.changes(other, 1));
  EXPECT_EQ(screen.cubes(), occupied_of(other, Shown{}));
  screen.take(markers.changes(OctoMapper(octo_options()), 2));
  EXPECT_TRUE(screen.cubes().empty());
}

}  // namespace
}  // namespace portolan
