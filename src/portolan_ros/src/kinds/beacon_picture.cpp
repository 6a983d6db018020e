// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/kinds/beacon_picture.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace portolan {

namespace {

constexpr Picture::Colour kPaper{252, 252, 250};
constexpr Picture::Colour kGrid{228, 230, 232};
constexpr Picture::Colour kWay{38, 110, 200};
constexpr Picture::Colour kDrive{200, 30, 40};
constexpr Picture::Colour kInk{20, 20, 20};
constexpr Picture::Colour kAmbiguous{232, 116, 12};
constexpr Picture::Colour kCertain{24, 140, 62};

constexpr double kStandardDeviations = 2.0;
constexpr double kFaintest = 0.1;
constexpr double kDot = 2.5;  // [pixel] half axis of the smallest ellipse

/// Digits, three pixels wide and five high, a row in each three bits from the top.
constexpr std::array<std::uint16_t, 10> kDigits{075557, 026227, 071747, 071717, 055711,
                                                074717, 074757, 071122, 075757, 075717};

/// From the map to pixels.
struct View {
  Eigen::Vector2d corner;  // top left [m]
  double scale;            // [pixel/m]

  Eigen::Vector2d pixel(const Eigen::Vector3d& p_map) const {
    return {(p_map.x() - corner.x()) * scale, (corner.y() - p_map.y()) * scale};
  }
};

Eigen::AlignedBox2d extent_of(const BeaconScene& scene) {
  if (scene.extent) return *scene.extent;
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3d& p : scene.way) box.extend(p.head<2>());
  for (const Eigen::Vector3d& p : scene.truth) box.extend(p.head<2>());
  for (const BeaconEstimate& beacon : scene.beacons) {
    for (const BeaconMode& mode : beacon.modes) box.extend(mode.mean.head<2>());
  }
  if (box.isEmpty()) box.extend(Eigen::Vector2d::Zero().eval());
  const double margin = std::max(0.06 * box.sizes().maxCoeff(), 0.5);
  return {box.min().array() - margin, box.max().array() + margin};
}

std::int64_t whole(double value) { return std::llround(std::floor(value)); }

void draw_grid(const View& view, Picture& picture) {
  const auto width = static_cast<double>(picture.width());
  const auto height = static_cast<double>(picture.height());
  const double step = std::pow(10.0, std::floor(std::log10(width / view.scale)));
  for (double x = std::ceil(view.corner.x() / step) * step; x * view.scale < 1e9; x += step) {
    const double column = (x - view.corner.x()) * view.scale;
    if (column > width) break;
    picture.line(column, 0.0, column, height, kGrid);
  }
  for (double y = std::floor(view.corner.y() / step) * step; y * view.scale > -1e9; y -= step) {
    const double row = (view.corner.y() - y) * view.scale;
    if (row > height) break;
    picture.line(0.0, row, width, row, kGrid);
  }
}

void draw_line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, Picture::Colour colour,
               Picture& picture) {
  for (const double off : {-1.0, 0.0, 1.0}) {
    picture.line(a.x() + off, a.y(), b.x() + off, b.y(), colour);
    picture.line(a.x(), a.y() + off, b.x(), b.y() + off, colour);
  }
}

void draw_mode(const BeaconMode& mode, const View& view, Picture::Colour colour, Picture& picture) {
  const Eigen::Vector2d center = view.pixel(mode.mean);
  Eigen::Matrix2d Q = view.scale * view.scale * mode.covariance.topLeftCorner<2, 2>();
  Q(0, 1) *= -1.0;  // rows run downwards
  Q(1, 0) *= -1.0;
  Q = kStandardDeviations * kStandardDeviations * Q + kDot * kDot * Eigen::Matrix2d::Identity();
  const Eigen::Matrix2d inverse = Q.inverse();
  const Eigen::Vector2d reach = Q.diagonal().cwiseSqrt();
  const double opacity = kFaintest + (0.9 - kFaintest) * mode.weight;
  const Eigen::Vector2d picture_size(static_cast<double>(picture.width()),
                                     static_cast<double>(picture.height()));
  const Eigen::Vector2d from = (center - reach).cwiseMax(0.0);
  const Eigen::Vector2d to = (center + reach).cwiseMin(picture_size);
  for (std::int64_t row = whole(from.y()); row <= whole(to.y()); ++row) {
    for (std::int64_t column = whole(from.x()); column <= whole(to.x()); ++column) {
      const Eigen::Vector2d step(static_cast<double>(column) + 0.5 - center.x(),
                                 static_cast<double>(row) + 0.5 - center.y());
      if (step.dot(inverse * step) <= 1.0) picture.mix(column, row, colour, opacity);
    }
  }
}

void draw_digit(std::uint16_t digit, std::int64_t column, std::int64_t row, Picture& picture) {
  constexpr std::int64_t kSize = 3;  // [pixel] a side of a dot
  for (std::int64_t i = 0; i < 15 * kSize * kSize; ++i) {
    const std::int64_t dot = i / (kSize * kSize);
    if ((digit >> (14 - dot) & 1) == 0) continue;
    picture.set(column + dot % 3 * kSize + i % kSize, row + dot / 3 * kSize + i / kSize % kSize,
                kInk);
  }
}

/// The numbers in a picture; one that would lie on another is left out.
class Numbers {
 public:
  void draw(BeaconId id, const Eigen::Vector2d& center, Picture& picture) {
    constexpr double kBeside = 10.0;      // [pixel]
    constexpr double kDigitWidth = 12.0;  // [pixel]
    const std::string digits = std::to_string(id);
    Eigen::Vector2d at = center + Eigen::Vector2d(kBeside, -2.0 * kBeside);
    const Eigen::Vector2d size(kDigitWidth * static_cast<double>(digits.size()), kDigitWidth + 3.0);
    const Eigen::AlignedBox2d box(at, at + size);
    for (const Eigen::AlignedBox2d& other : drawn_) {
      if (other.intersects(box)) return;
    }
    drawn_.push_back(box);
    for (const char digit : digits) {
      draw_digit(kDigits.at(static_cast<std::size_t>(digit - '0')), whole(at.x()), whole(at.y()),
                 picture);
      at.x() += kDigitWidth;
    }
  }

 private:
  std::vector<Eigen::AlignedBox2d> drawn_;  // [pixel]
};

void draw_places(const BeaconEstimate& beacon, const View& view, Picture& picture) {
  const Picture::Colour colour = beacon.ambiguous ? kAmbiguous : kCertain;
  for (const BeaconMode& mode : beacon.modes) draw_mode(mode, view, colour, picture);
  if (!beacon.drive) return;
  const BeaconDrive& drive = *beacon.drive;
  draw_line(view.pixel(drive.p_map), view.pixel(drive.p_map + drive.distance * drive.direction),
            kDrive, picture);
}

void draw_cross(const Eigen::Vector2d& at, Picture& picture) {
  const Eigen::Vector2d along(7.0, 7.0);
  const Eigen::Vector2d across(7.0, -7.0);
  draw_line(at - along, at + along, kInk, picture);
  draw_line(at - across, at + across, kInk, picture);
}

}  // namespace

Picture beacon_picture(const BeaconScene& scene, std::size_t side) {
  const Eigen::AlignedBox2d extent = extent_of(scene);
  const double scale = static_cast<double>(side) / extent.sizes().maxCoeff();
  const View view{{extent.min().x(), extent.max().y()}, scale};
  const Eigen::Vector2d size = (scale * extent.sizes()).array().ceil();
  Picture picture(static_cast<std::size_t>(size.x()), static_cast<std::size_t>(size.y()), kPaper);
  draw_grid(view, picture);
  for (std::size_t i = 1; i < scene.way.size(); ++i) {
    draw_line(view.pixel(scene.way[i - 1]), view.pixel(scene.way[i]), kWay, picture);
  }
  for (const BeaconEstimate& beacon : scene.beacons) draw_places(beacon, view, picture);
  Numbers numbers;
  for (const BeaconEstimate& beacon : scene.beacons) {
    if (beacon.modes.empty()) continue;
    numbers.draw(beacon.id, view.pixel(beacon.modes[0].mean), picture);
  }
  for (const Eigen::Vector3d& p_map : scene.truth) draw_cross(view.pixel(p_map), picture);
  return picture;
}

}  // namespace portolan
