// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <cstddef>
#include <string>
#include <utility>

#include "portolan/beacon/beacon_mapper.hpp"
#include "portolan/options.hpp"
#include "portolan/remapper.hpp"

namespace portolan {

/// How a map of beacons leaves the node.
struct BeaconOutputOptions {
  double marker_stddevs = 2.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("marker_stddevs", self.marker_stddevs,
          "half axes of the ellipsoids on `beacons_vis`, in standard deviations", above(0.0));
  }
};

/// The topics of the map of beacons: `beacons`, latched, and `beacons_vis`. Makes messages only
/// while someone listens and something is new.
class BeaconOutputs {
 public:
  BeaconOutputs(ros::NodeHandle& handle, const BeaconOutputOptions& options, std::string map_frame,
                const Remapper<BeaconMapper>& source);
  BeaconOutputs(const BeaconOutputs&) = delete;  // the publishers call back into this object
  BeaconOutputs& operator=(const BeaconOutputs&) = delete;

  void publish(const ros::Time& stamp);

 private:
  /// Which map it is, and how many ranges it was given.
  using Version = std::pair<std::size_t, std::size_t>;
  Version version() const;

  const Remapper<BeaconMapper>& source_;
  BeaconOutputOptions options_;
  std::string map_frame_;
  ros::Publisher beacons_;
  ros::Publisher markers_;
  Version published_;
  bool someone_came_ = false;
};

}  // namespace portolan
