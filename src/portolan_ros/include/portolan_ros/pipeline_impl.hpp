// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How a Pipeline works; pipeline.hpp, which includes this, says what it does.

#include <optional>
#include <type_traits>
#include <utility>

#include "portolan_ros/convert/basics.hpp"
#include "portolan_ros/pipeline.hpp"

namespace portolan {

namespace pipeline_detail {

template <class T, class = void>
struct HasMotion : std::false_type {};
template <class T>
struct HasMotion<T, std::void_t<decltype(std::declval<T&>().T_first_last)>> : std::true_type {};

template <class Filter, class T, class = void>
struct IsNoted : std::false_type {};
template <class Filter, class T>
struct IsNoted<Filter, T, std::void_t<decltype(std::declval<Filter&>().note(std::declval<T>()))>>
    : std::true_type {};

}  // namespace pipeline_detail

template <class Kind>
template <class SensorReading>
void Pipeline<Kind>::receive(std::size_t input, std::optional<Sensed<SensorReading>> sensed,
                             Time now) {
  poll(now);
  if (!sensed) return posed_.receive_malformed(input);
  if constexpr (pipeline_detail::IsNoted<FilterOf<Kind>, SensorReading>::value) {
    filter_.note(std::move(sensed->z));
    return posed_.receive_unposed(input);
  } else {
    pose_and_use(input, std::move(*sensed), now);
  }
}

template <class Kind>
template <class SensorReading>
void Pipeline<Kind>::pose_and_use(std::size_t input, Sensed<SensorReading> sensed, Time now) {
  const SensorId sensor = sensor_id(input, ros_convert::without_slash(sensed.frame));
  PosedInput::Message message{sensed.frame, sensed.first, sensed.last, {}, {}, sensed.part};
  message.references = filter_.references(sensed.z);
  message.use = [this, sensor, stamp = sensed.first,
                 z = std::move(sensed.z)](const PosedInput::SensorPose& pose) mutable {
    if constexpr (pipeline_detail::HasMotion<SensorReading>::value) {
      z.T_first_last = pose.T_first_last;
    }
    return remapper_.observe(stamp, pose.T_odom_sensor, filter_(std::move(z), pose), sensor);
  };
  posed_.receive(input, std::move(message), now);
}

}  // namespace portolan
