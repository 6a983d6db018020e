// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>

#include "portolan/landmark/inverse_depth.hpp"
#include "portolan/landmark/place_filter.hpp"
#include "portolan_ros/picture.hpp"
#include "portolan_ros/report.hpp"

namespace portolan {
namespace {

constexpr Picture::Colour kPaper{252, 252, 250};
constexpr Picture::Colour kCamera{38, 110, 200};
constexpr Picture::Colour kTruth{200, 30, 40};
constexpr Picture::Colour kRay{232, 116, 12};
constexpr Picture::Colour kPoint{24, 140, 62};
constexpr double kScale = 90.0;  // [pixel/m]

struct Pixel {
  std::int64_t column;
  std::int64_t row;
};

Pixel pixel(const Eigen::Vector3d& p_map) {
  return {std::llround(40.0 + kScale * p_map.x()), std::llround(180.0 - kScale * p_map.y())};
}

void dot(const Eigen::Vector3d& p_map, std::int64_t half, Picture::Colour colour, double opacity,
         Picture& picture) {
  const Pixel at = pixel(p_map);
  for (std::int64_t i = -half; i <= half; ++i) {
    for (std::int64_t j = -half; j <= half; ++j)
      picture.mix(at.column + i, at.row + j, colour, opacity);
  }
}

/// Samples of the Gaussian, in the coordinates in which it is one.
void draw_place(const Place& place, std::mt19937& random, Picture& picture) {
  const Eigen::Matrix3d L = place.covariance.llt().matrixL();
  std::normal_distribution<double> normal;
  for (int i = 0; i < 6000; ++i) {
    const Eigen::Vector3d unit(normal(random), normal(random), normal(random));
    const Eigen::Vector3d x = place.mean + L * unit;
    if (place.form == PlaceForm::point) {
      dot(x, 0, kPoint, 0.3, picture);
    } else if (x[2] > 0.05) {
      dot(InverseDepth::point(place.T_map_ray, x), 0, kRay, 0.3, picture);
    }
  }
}

/// Figure 10: what a camera knows of one landmark after it moved along `step` a few times.
Picture parallax(const Eigen::Vector3d& step, int sightings) {
  const Eigen::Vector3d landmark(4.0, 0.4, 0.0);
  LandmarkOptions options;
  options.unmeasured.min_depth = 1.0;
  options.unmeasured.max_depth = 20.0;
  std::mt19937 random(1);
  Picture picture(960, 360, kPaper);
  Place place;
  for (int i = 0; i < sightings; ++i) {
    UncertainSensorPose sensor;
    sensor.T_map_sensor.translation() = i * step;
    const Eigen::Vector2d angles = DirectionModel::h(sensor.T_map_sensor.inverse() * landmark);
    const Measured<DirectionModel> z{{}, angles, {1e-4, 1e-4}};
    if (i == 0) {
      place = first_place(z, sensor, options);
    } else {
      update(place, z, sensor, 1.0, options);
    }
    dot(sensor.T_map_sensor.translation(), 3, kCamera, 1.0, picture);
  }
  draw_place(place, random, picture);
  dot(landmark, 3, kTruth, 1.0, picture);
  return picture;
}

void write(const std::string& path, const Picture& picture) {
  std::ofstream file(path, std::ios::binary);
  file << picture.png();
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

constexpr const char* kUsage =
    "usage: draw_parallax FOLDER\n"
    "Draws Figure 10 of the chapter: one sighting, little parallax, much parallax.\n";

}  // namespace
}  // namespace portolan

int main(int argc, char** argv) try {
  using portolan::parallax;
  if (const auto code = portolan::exit_with_usage(argc, argv, 1, 1, portolan::kUsage)) return *code;
  const std::string folder = argv[1];
  std::filesystem::create_directories(folder);
  portolan::write(folder + "/figure_10_first.png", parallax({0.0, 0.0, 0.0}, 1));
  portolan::write(folder + "/figure_10_small.png", parallax({0.25, 0.0, 0.0}, 5));
  portolan::write(folder + "/figure_10_large.png", parallax({0.0, -0.25, 0.0}, 5));
  return 0;
} catch (const std::exception& error) {
  return portolan::report(error);
}
