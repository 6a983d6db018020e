// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "portolan/observation/image_features.hpp"
#include "portolan/sim/random.hpp"
#include "portolan/sim/sensor_options.hpp"
#include "portolan/sim/world.hpp"

namespace portolan::sim {

/// A camera in whose images the landmarks are found as features.
class Camera {
 public:
  struct Options : SensorOptions {
    int width = 640;
    int height = 480;
    double fx = 500.0;
    double fy = 500.0;
    double cx = 319.5;
    double cy = 239.5;
    double reach = 12.0;
    double pixel_stddev = 0.5;
    double dropout = 0.0;
    double outliers = 0.0;
    bool identities = true;

    Options() {
      frame = "camera_optical";
      topic = "image_features";
      position = {0.2, 0.0, 0.5};
    }

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor& visit) {
      SensorOptions::describe(self, visit);
      visit("width", self.width, "of the image [pixel]", within(1, 100000));
      visit("height", self.height, "of the image [pixel]", within(1, 100000));
      visit("fx", self.fx, "focal length [pixel]", above(0.0));
      visit("fy", self.fy, "focal length [pixel]", above(0.0));
      visit("cx", self.cx, "column of the optical axis [pixel]");
      visit("cy", self.cy, "row of the optical axis [pixel]");
      visit("reach", self.reach, "landmarks further away are not found [m]", above(0.0));
      visit("pixel_stddev", self.pixel_stddev, "deviation of a feature [pixel]", at_least(0.0));
      visit("dropout", self.dropout, "P(a landmark in view is not found)", within(0.0, 1.0));
      visit("outliers", self.outliers, "P(it is found anywhere in the image)", within(0.0, 1.0));
      visit("identities", self.identities, "says which landmark it is");
    }
  };

  Camera(const Options& options, std::uint64_t seed);

  /// The features of every landmark in the image that is not hidden. The sensor's frame is the
  /// optical one.
  ImageFeatures sense(const World& world, const Pose& T_map_sensor);

  const Options& options() const { return options_; }

 private:
  Options options_;
  Random random_;
};

}  // namespace portolan::sim
