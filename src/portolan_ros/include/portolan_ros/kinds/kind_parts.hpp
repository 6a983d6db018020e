// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What a kind of map may have beyond the parts that each has, and what stands in where it has not.

#include <ros/node_handle.h>

#include <cstdint>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace portolan {

/// Hands on all that the sensors saw as it is.
///
/// A kind with a type `Filter` of the same shape has one of its own. It is built from its options,
/// those of the pipeline and the mapper's; `references` names the frames in which it needs to know
/// the sensor's pose; and the call makes an observation of what was seen from there. It must not
/// ask for the map frame: a correction that comes later has to find the same observations. What it
/// has a function `note(reading)` for is given to that at once, whatever tf says, and is no
/// observation: how a camera draws.
struct NoFilter {
  struct Options {
    template <class Self, class Visitor>
    static void describe(Self& /*self*/, Visitor& /*visit*/) {}
  };

  template <class PipelineOptions, class MapperOptions>
  NoFilter(const Options& /*options*/, const PipelineOptions& /*pipeline*/,
           const MapperOptions& /*mapper*/) {}

  template <class SensorReading>
  std::vector<std::string> references(const SensorReading& /*z*/) const {
    return {};
  }

  template <class SensorReading, class SensorPose>
  SensorReading operator()(SensorReading z, const SensorPose& /*pose*/) const {
    return z;
  }
};

/// Nothing more than the services that every mapper node offers.
///
/// A kind with a type `Services` of the same shape offers those too.
struct NoServices {
  template <class Source>
  NoServices(ros::NodeHandle& /*private_handle*/, Source& /*source*/) {}
};

namespace kind_detail {

template <class Kind, class = void>
struct Filter {
  using Type = NoFilter;
};
template <class Kind>
struct Filter<Kind, std::void_t<typename Kind::Filter>> {
  using Type = typename Kind::Filter;
};

template <class Kind, class = void>
struct Services {
  using Type = NoServices;
};
template <class Kind>
struct Services<Kind, std::void_t<typename Kind::Services>> {
  using Type = typename Kind::Services;
};

template <class Kind, class Map, class = void>
struct Counts {
  static std::map<std::string, std::uint64_t> of(const Map& /*map*/) { return {}; }
};
template <class Kind, class Map>
struct Counts<Kind, Map, std::void_t<decltype(Kind::counts(std::declval<const Map&>()))>> {
  static std::map<std::string, std::uint64_t> of(const Map& map) { return Kind::counts(map); }
};

}  // namespace kind_detail

template <class Kind>
using FilterOf = typename kind_detail::Filter<Kind>::Type;

template <class Kind>
using ServicesOf = typename kind_detail::Services<Kind>::Type;

/// What the map itself counted, for diagnostics; a kind says it with a function `counts(map)`.
template <class Kind, class Map>
std::map<std::string, std::uint64_t> counts_of(const Map& map) {
  return kind_detail::Counts<Kind, Map>::of(map);
}

}  // namespace portolan
