// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/beacon/inverse_range.hpp"

#include <algorithm>
#include <cmath>

namespace portolan {

namespace {

constexpr double kPi = 3.14159265358979323846;

// A Gaussian of standard deviation t across a sphere of radius r bends away from it by
// t^2 / (2 r): this is how much of the range's deviation that may be.
constexpr double kBend = 0.15;
// Distance of neighbours in standard deviations: a row of Gaussians so far apart is flat to 1 %.
constexpr double kSpacing = 1.7;

// A ring of four Gaussians 90 degrees apart and 50 wide, as in Figure 12, is flat to 1 %.
constexpr int kPolarColumns = 4;
constexpr double kPolarStep = 2.0 * kPi / kPolarColumns;
constexpr double kPolarDeviation = 50.0 / 180.0 * kPi;

struct Sphere {
  double distance;           // mean distance given the reading [m]
  double variance;           // of it [m^2]
  Eigen::RowVector3d slope;  // d distance / d (scale, bias, turn)
};

Sphere sphere_of(const PosedRange& z, const RangeCalibration& c, int free_dimensions) {
  Sphere sphere;
  const double distance = std::max((z.range - c.bias) / c.scale, 0.0);
  sphere.variance = z.stddev * z.stddev / (c.scale * c.scale);
  // A shell has more room outside than inside: p(d) ~ d^(n-1) N(d), whose mean lies further out.
  const double reach = std::max(distance, std::sqrt(sphere.variance));
  sphere.distance = distance + (free_dimensions - 1) * sphere.variance / reach;
  sphere.slope = Eigen::RowVector3d(-sphere.distance, -1.0, 0.0) / c.scale;
  return sphere;
}

// A Gaussian on the sphere in direction u: thin along it, `tangent` wide along each axis across.
Hypothesis tangent_mode(const Eigen::Vector3d& center, const Eigen::Vector3d& u, double radius,
                        double variance, double tangent, const Eigen::RowVector3d& slope,
                        const Eigen::Matrix3d& space, const RangeCalibration& c) {
  Hypothesis mode;
  const Eigen::Matrix3d across = space - u * u.transpose();
  mode.Q = variance * u * u.transpose() + tangent * tangent * across;
  mode.G = u * slope;
  mode.x = center + radius * u - mode.G * c.deviation;
  return mode;
}

void blob(const Eigen::Vector3d& center, double variance, const Eigen::Matrix3d& space,
          std::vector<Hypothesis>& modes) {
  Hypothesis mode;
  mode.x = center;
  mode.Q = variance * space;
  modes.assign(1, mode);
}

void normalize(std::vector<Hypothesis>& modes) {
  double total = 0.0;
  for (const Hypothesis& mode : modes) total += std::exp(mode.log_weight);
  for (Hypothesis& mode : modes) {
    mode.log_weight -= std::log(total);
    mode.weight = std::exp(mode.log_weight);
  }
}

double tangent_deviation(double radius, double deviation) {
  return std::sqrt(2.0 * kBend * radius * deviation);
}

// The bend puts tangent Gaussians outside the sphere on average, and widens them: undo both.
double bent_radius(double radius, double tangent, int tangents) {
  return radius - 0.5 * tangents * tangent * tangent / radius;
}
double bent_variance(double variance, double radius, double tangent, int tangents) {
  const double bend = tangent * tangent / radius;
  return std::max(variance - 0.5 * tangents * bend * bend, 0.25 * variance);
}

double height_squared(const BeaconOptions& options) {
  return options.space == BeaconSpace::planar ? options.height * options.height : 0.0;
}

void ring(const PosedRange& z, const RangeCalibration& c, const BeaconOptions& options,
          std::vector<Hypothesis>& modes) {
  const Sphere sphere = sphere_of(z, c, 2);
  const Eigen::Matrix3d plane = Eigen::Vector3d(1.0, 1.0, 0.0).asDiagonal();
  const Eigen::Vector3d center(z.p_map.x(), z.p_map.y(), 0.0);
  const double squared = sphere.distance * sphere.distance - height_squared(options);
  const double blur = 2.0 * sphere.distance * std::sqrt(sphere.variance);  // of the square
  if (squared <= blur) {
    return blob(center, 0.5 * (std::max(squared, 0.0) + blur), plane, modes);
  }
  const double radius = std::sqrt(squared);
  const double stretch = sphere.distance / radius;  // d radius / d distance
  const double variance = stretch * stretch * sphere.variance;
  const double wanted =
      2.0 * kPi * radius / (kSpacing * tangent_deviation(radius, std::sqrt(variance)));
  const auto count = static_cast<std::size_t>(
      std::clamp(std::ceil(wanted), 8.0, static_cast<double>(options.max_modes)));
  const double tangent = 2.0 * kPi * radius / (kSpacing * static_cast<double>(count));
  const double r = bent_radius(radius, tangent, 1);
  modes.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const double azimuth = 2.0 * kPi * static_cast<double>(i) / static_cast<double>(count);
    const Eigen::Vector3d u(std::cos(azimuth), std::sin(azimuth), 0.0);
    modes.push_back(tangent_mode(center, u, r, bent_variance(variance, radius, tangent, 1), tangent,
                                 stretch * sphere.slope, plane, c));
  }
}

void shell(const PosedRange& z, const RangeCalibration& c, const BeaconOptions& options,
           std::vector<Hypothesis>& modes) {
  const Sphere sphere = sphere_of(z, c, 3);
  const Eigen::Matrix3d space = Eigen::Matrix3d::Identity();
  const double deviation = std::sqrt(sphere.variance);
  if (sphere.distance <= 2.0 * deviation) {
    const double variance = sphere.distance * sphere.distance / 3.0 + sphere.variance;
    return blob(z.p_map, variance, space, modes);
  }
  const double band = options.elevation_max - options.elevation_min;
  const double area =
      2.0 * kPi *
      (std::sin(options.elevation_max) - std::sin(options.elevation_min));  // on the unit sphere
  const double affordable = std::sqrt(area / (0.8 * static_cast<double>(options.max_modes)));
  const double wanted = kSpacing * tangent_deviation(sphere.distance, deviation) / sphere.distance;
  const auto rows = static_cast<int>(std::ceil(band / std::max(wanted, affordable)));
  const double step = band / rows;
  const double tangent = step * sphere.distance / kSpacing;
  const double r = bent_radius(sphere.distance, tangent, 2);
  const double variance = bent_variance(sphere.variance, sphere.distance, tangent, 2);
  modes.clear();
  for (int row = 0; row < rows; ++row) {
    const double elevation = options.elevation_min + (row + 0.5) * step;
    const auto columns =
        std::max(1, static_cast<int>(std::ceil(2.0 * kPi * std::cos(elevation) / step)));
    for (int column = 0; column < columns; ++column) {
      const double azimuth = 2.0 * kPi * (column + 0.5 * (row % 2)) / columns;
      const Eigen::Vector3d u(std::cos(elevation) * std::cos(azimuth),
                              std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
      modes.push_back(tangent_mode(z.p_map, u, r, variance, tangent, sphere.slope, space, c));
      modes.back().log_weight = std::log(std::cos(elevation) / columns);
    }
  }
}

}  // namespace

void inverse_range(const PosedRange& z, const RangeCalibration& calibration,
                   const BeaconOptions& options, std::vector<Hypothesis>& modes) {
  if (options.space == BeaconSpace::planar) {
    ring(z, calibration, options, modes);
  } else {
    shell(z, calibration, options, modes);
  }
  normalize(modes);
}

void inverse_range_polar(const PosedRange& z, const RangeCalibration& calibration,
                         const BeaconOptions& options, std::vector<Hypothesis>& modes) {
  const bool planar = options.space == BeaconSpace::planar;
  const Sphere sphere = sphere_of(z, calibration, planar ? 2 : 3);
  const double blur = 2.0 * sphere.distance * std::sqrt(sphere.variance);
  const double squared = sphere.distance * sphere.distance - height_squared(options);
  if (squared <= blur) return inverse_range(z, calibration, options, modes);
  const double radius = std::sqrt(squared);
  const double stretch = sphere.distance / radius;
  const double band = planar ? 0.0 : options.elevation_max - options.elevation_min;
  const int rows = planar ? 1 : static_cast<int>(std::ceil(band / kPolarStep));
  modes.clear();
  for (int row = 0; row < rows; ++row) {
    const double elevation = planar ? 0.0 : options.elevation_min + (row + 0.5) * band / rows;
    for (int column = 0; column < kPolarColumns; ++column) {
      Hypothesis mode;
      mode.is_polar = true;
      mode.log_weight = std::log(std::cos(elevation));
      mode.G.row(0) = stretch * sphere.slope;
      mode.x =
          Eigen::Vector3d(radius, column * kPolarStep, elevation) - mode.G * calibration.deviation;
      mode.Q.diagonal() << stretch * stretch * sphere.variance, kPolarDeviation * kPolarDeviation,
          std::pow(band / rows / kSpacing, 2);
      modes.push_back(mode);
    }
  }
  normalize(modes);
}

}  // namespace portolan
