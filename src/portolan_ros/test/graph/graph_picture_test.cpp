// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/graph/graph_picture.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <set>

#include "decoded_png.hpp"

namespace portolan {
namespace {

Pose at(double x, double y) { return Pose(Eigen::Translation3d(x, y, 0.0)); }

Arc arc(PoseId from, PoseId to, ArcKind kind, ArcState state) {
  Arc made;
  made.from = from;
  made.to = to;
  made.kind = kind;
  made.state = state;
  made.information = TangentMatrix::Identity();
  return made;
}

/// A right angle, 8 m along x and 3 m up, that a loop closes.
Graph corner(ArcState loop) {
  Graph graph;
  graph.add({0, Time{}, at(0.0, 0.0)});
  graph.add({1, Time{}, at(8.0, 0.0)});
  graph.add({2, Time{}, at(8.0, 3.0)});
  graph.add(arc(0, 1, ArcKind::odometry, ArcState::accepted));
  graph.add(arc(1, 2, ArcKind::scan, ArcState::accepted));
  graph.add(arc(2, 0, ArcKind::loop, loop));
  return graph;
}

std::set<Picture::Colour> colours(const DecodedPng& picture) {
  std::set<Picture::Colour> all;
  for (std::size_t row = 0; row < picture.height; ++row) {
    for (std::size_t column = 0; column < picture.width; ++column) {
      all.insert(picture.at(column, row));
    }
  }
  return all;
}

TEST(GraphPicture, OfNothingIsNothing) { EXPECT_TRUE(graph_picture(Graph()).empty()); }

TEST(GraphPicture, ShowsTheWholeGraphFromAboveWithYUp) {
  const DecodedPng picture(graph_picture(corner(ArcState::accepted)));
  // 10 m by 5 m with a margin of a metre: 140 pixels to the metre.
  ASSERT_EQ(picture.width, 1401U);
  ASSERT_EQ(picture.height, 701U);
  const Picture::Colour paper = picture.at(0, 0);
  EXPECT_NE(picture.at(700, 560), paper);   // (4, 0)
  EXPECT_NE(picture.at(1260, 350), paper);  // (8, 1.5)
  EXPECT_NE(picture.at(700, 350), paper);   // (4, 1.5)
  EXPECT_EQ(picture.at(700, 200), paper);
}

TEST(GraphPicture, TellsWayLoopsAndRejectedArcsApart) {
  const DecodedPng accepted(graph_picture(corner(ArcState::accepted)));
  const DecodedPng rejected(graph_picture(corner(ArcState::rejected)));
  EXPECT_EQ(colours(accepted).size(), 3U);
  EXPECT_EQ(colours(rejected).size(), 3U);
  EXPECT_NE(accepted.at(700, 350), rejected.at(700, 350));
  EXPECT_EQ(accepted.at(700, 560), rejected.at(700, 560));
}

TEST(GraphPicture, LiesOverTheSurfacesAndShowsThemAll) {
  const DecodedPng picture(graph_picture(corner(ArcState::accepted), {{4.0, 5.0}, {4.0, 0.0}}));
  EXPECT_EQ(colours(picture).size(), 4U);
  const DecodedPng bare(graph_picture(corner(ArcState::accepted)));
  EXPECT_GT(picture.height, bare.height);
}

}  // namespace
}  // namespace portolan
