// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/picture.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

#include "decoded_png.hpp"

namespace portolan {
namespace {

constexpr Picture::Colour kWhite = {255, 255, 255};
constexpr Picture::Colour kBlack = {0, 0, 0};
constexpr Picture::Colour kRed = {200, 10, 20};

/// As text, rows from the top: '#' where anything was drawn.
std::string drawn(const Picture& picture) {
  const DecodedPng decoded(picture.png());
  std::string text;
  for (std::size_t row = 0; row < decoded.height; ++row) {
    text += '\n';
    for (std::size_t column = 0; column < decoded.width; ++column) {
      text += decoded.at(column, row) == kWhite ? '.' : '#';
    }
  }
  return text;
}

TEST(Picture, IsReadBackAsItWasDrawn) {
  Picture picture(7, 3, kWhite);
  picture.set(0, 0, kBlack);
  picture.set(6, 2, kRed);
  const DecodedPng decoded(picture.png());
  ASSERT_EQ(decoded.width, 7u);
  ASSERT_EQ(decoded.height, 3u);
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 7; ++column) {
      const bool first = row == 0 && column == 0;
      const bool last = row == 2 && column == 6;
      EXPECT_EQ(decoded.at(column, row), first ? kBlack : last ? kRed : kWhite);
    }
  }
}

TEST(Picture, GivesTheSameBytesEachTime) {
  const auto draw = [] {
    Picture picture(300, 200, kWhite);
    picture.line(0.0, 0.0, 299.0, 150.0, kRed);
    return picture.png();
  };
  EXPECT_EQ(draw(), draw());
  EXPECT_EQ(draw().substr(1, 3), "PNG");
}

TEST(Picture, LeavesOutPixelsOutside) {
  Picture picture(4, 2, kWhite);
  constexpr std::int64_t kFar = std::numeric_limits<std::int64_t>::max();
  picture.set(-1, 0, kBlack);
  picture.set(0, -1, kBlack);
  picture.set(4, 0, kBlack);
  picture.set(0, 2, kBlack);
  picture.set(kFar, kFar, kBlack);
  picture.set(-kFar, -kFar, kBlack);
  EXPECT_EQ(drawn(picture), "\n....\n....");
}

TEST(Picture, DrawsLines) {
  Picture picture(6, 4, kWhite);
  picture.line(0.5, 0.5, 5.5, 0.5, kBlack);
  picture.line(1.5, 3.5, 3.5, 1.5, kBlack);
  EXPECT_EQ(drawn(picture), R"(
######
...#..
..#...
.#....)");
}

TEST(Picture, ALineWithoutLengthIsAPoint) {
  Picture picture(3, 2, kWhite);
  picture.line(1.2, 1.9, 1.2, 1.9, kBlack);
  EXPECT_EQ(drawn(picture), "\n...\n.#.");
}

TEST(Picture, DrawsOfALineWhatLiesInside) {
  Picture picture(6, 4, kWhite);
  picture.line(-3.5, 0.5, 2.5, 0.5, kBlack);
  picture.line(-1e9, 2.5, 1e9, 2.5, kBlack);
  picture.line(4.5, -1e5, 4.5, 1e5, kBlack);
  EXPECT_EQ(drawn(picture), R"(
###.#.
....#.
######
....#.)");
}

TEST(Picture, DrawsNothingOfALineOutside) {
  Picture picture(3, 2, kWhite);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  picture.line(-5.0, -1.0, 50.0, -1.0, kBlack);
  picture.line(4.0, -9.0, 4.0, 9.0, kBlack);
  picture.line(-10.0, 5.0, 5.0, 20.0, kBlack);
  picture.line(1e300, 1e300, 1e300, 1e300, kBlack);
  picture.line(-1e308, 0.0, 1e308, 0.0, kBlack);  // longer than any number
  picture.line(nan, 0.0, 1.0, 1.0, kBlack);
  picture.line(0.0, 0.0, 1.0, nan, kBlack);
  picture.line(-inf, 0.0, inf, 0.0, kBlack);
  picture.line(inf, 0.0, inf, 0.0, kBlack);
  EXPECT_EQ(drawn(picture), "\n...\n...");
}

TEST(Picture, GrowsBySquares) {
  Picture picture(3, 2, kWhite);
  picture.set(1, 0, kBlack);
  picture.set(2, 1, kBlack);
  EXPECT_EQ(drawn(picture.enlarged(1)), drawn(picture));
  EXPECT_EQ(drawn(picture.enlarged(2)), R"(
..##..
..##..
....##
....##)");
}

TEST(Picture, RefusesSizesThatCannotBe) {
  const std::size_t most = std::numeric_limits<std::size_t>::max();
  EXPECT_THROW(Picture(0, 5, kWhite), std::invalid_argument);
  EXPECT_THROW(Picture(5, 0, kWhite), std::invalid_argument);
  EXPECT_THROW(Picture(std::size_t{1} << 15, (std::size_t{1} << 13) + 1, kWhite),
               std::invalid_argument);
  EXPECT_THROW(Picture(most, most, kWhite), std::invalid_argument);
  EXPECT_THROW(Picture(1, 1, kWhite).enlarged(0), std::invalid_argument);
  EXPECT_THROW(Picture(4, 4, kWhite).enlarged(std::size_t{1} << 63), std::invalid_argument);
  EXPECT_THROW(Picture(3, 3, kWhite).enlarged(most / 3 + 1), std::invalid_argument);
}

}  // namespace
}  // namespace portolan
