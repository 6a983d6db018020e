// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/camera.hpp"

namespace portolan::sim {

Camera::Camera(const Options& options, std::uint64_t seed)
    : options_(checked(options)), random_(seed, options.frame) {}

ImageFeatures Camera::sense(const World& world, const Pose& T_map_sensor) {
  ImageFeatures z;
  z.camera = {options_.fx, options_.fy, options_.cx, options_.cy};
  // The image reaches half a pixel beyond the centres of its border pixels.
  const double right = options_.width - 0.5;
  const double bottom = options_.height - 0.5;
  const auto in_image = [&](double u, double v) {
    return u >= -0.5 && u < right && v >= -0.5 && v < bottom;
  };
  const Pose T_sensor_map = T_map_sensor.inverse();
  for (const auto& [id, p_map] : world.landmarks()) {
    const Eigen::Vector3d p = T_sensor_map * p_map;
    if (p.z() <= 0.0 || p.norm() > options_.reach) continue;
    const double u = options_.fx * p.x() / p.z() + options_.cx;
    const double v = options_.fy * p.y() / p.z() + options_.cy;
    if (!in_image(u, v) || !world.sees(T_map_sensor.translation(), p_map)) continue;

    const bool dropped = random_.chance(options_.dropout);
    const bool wild = random_.chance(options_.outliers);
    const double any_u = random_.uniform(-0.5, right);
    const double any_v = random_.uniform(-0.5, bottom);
    ImageFeature feature;
    if (options_.identities) feature.id = id;
    feature.u = random_.normal(u, options_.pixel_stddev);
    feature.v = random_.normal(v, options_.pixel_stddev);
    if (wild) {
      feature.u = any_u;
      feature.v = any_v;
    }
    if (!dropped && in_image(feature.u, feature.v)) z.features.push_back(feature);
  }
  return z;
}

}  // namespace portolan::sim
