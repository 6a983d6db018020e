// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include "portolan/observation/range_echo.hpp"
#include "portolan/observation/range_scan.hpp"
#include "portolan/options.hpp"
#include "portolan/outcome.hpp"
#include "portolan/pose.hpp"

namespace portolan {

using ToyObservation = std::variant<RangeScan, RangeEcho>;

inline std::size_t byte_size(const ToyObservation& z) { return sizeof(z); }

/// A map that is the list of what was inserted, and where. It has no place for what was seen at
/// x < 0, nor for echoes of 13 m.
class ToyMapper {
 public:
  struct Options {
    double resolution = 0.1;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor& visit) {
      visit("resolution", self.resolution, "side of a cell [m]", above(0.0));
    }
  };
  using Observation = ToyObservation;
  struct Entry {
    ToyObservation z;
    Pose T_map_sensor;
  };

  explicit ToyMapper(const Options& options) { checked(options); }

  Outcome insert(const ToyObservation& z, const Pose& T_map_sensor) {
    const RangeEcho* echo = std::get_if<RangeEcho>(&z);
    if (echo != nullptr && echo->range == 13.0) return Outcome::unusable;
    if (T_map_sensor.translation().x() < 0.0) return Outcome::rejected;
    entries_.push_back({z, T_map_sensor});
    return Outcome::inserted;
  }

  const std::vector<Entry>& entries() const { return entries_; }

 private:
  std::vector<Entry> entries_;
};

/// All of a kind of map that a `Pipeline` asks for.
struct ToyKind {
  using Mapper = ToyMapper;
};

}  // namespace portolan
