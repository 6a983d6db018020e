// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "portolan_ros/clock_guard.hpp"
#include "portolan_ros/convert/basics.hpp"
#include "portolan_ros/mapper_node_options.hpp"
#include "portolan_ros/sensed.hpp"

namespace portolan {

/// From messages to a map, for one kind of map: tf, the inputs, the log and the mapper.
/// It knows no ROS graph and asks no clock, so a live node and a bag go the same way.
template <class Kind>
class Pipeline {
 public:
  using Mapper = typename Kind::Mapper;
  using Observation = typename Mapper::Observation;

  /// Throws OptionsError.
  Pipeline(const PipelineOptions& options, const typename Mapper::Options& mapper_options,
           const typename FilterOf<Kind>::Options& filter_options = {})
      : options_(options),
        filter_(filter_options, options, mapper_options),
        posed_(options.posing),
        remapper_(options.remapper, mapper_options) {}
  Pipeline(const Pipeline&) = delete;  // messages that wait call back into this object
  Pipeline& operator=(const Pipeline&) = delete;

  /// Opens an input; gives its number.
  std::size_t add_input(const std::string& noun) { return posed_.add_input(noun); }

  /// Takes a message of an input: `sensed` is what it was converted to, none if malformed.
  template <class SensorReading>
  void receive(std::size_t input, std::optional<Sensed<SensorReading>> sensed, Time now);

  void receive_tf(const tf2_msgs::TFMessage& message, bool is_static, Time now) {
    check_clock(now);
    posed_.receive_tf(message, is_static, now);
    if (posed_.transforms_ran_back()) forget_for_time_jump();
    posed_.poll(now);
  }

  void receive_odometry(const nav_msgs::Odometry& message, Time now) {
    check_clock(now);
    posed_.receive_odometry(message, options_.base_frame, now);
    if (posed_.transforms_ran_back()) forget_for_time_jump();
    posed_.poll(now);
  }

  /// To be called now and then: notices a clock that ran back, and uses or drops what waits for
  /// tf.
  void poll(Time now) {
    check_clock(now);
    posed_.poll(now);
    if (early_ && now > early_->since + kLead) take_early_correction();
  }

  /// Takes a correction that its sender worked out at `stamp`. One whose stamp runs back tells of a
  /// jump that the sender noticed first: it waits for the clock here to run back too, for a second
  /// at most, so that it moves nothing that was mapped before.
  void correct(Correction correction, Time stamp, Time now);

  Remapper<Mapper>& remapper() { return remapper_; }
  const Remapper<Mapper>& remapper() const { return remapper_; }
  const PosedInput& posed() const { return posed_; }
  std::size_t time_jumps() const { return time_jumps_; }

 private:
  template <class SensorReading>
  void pose_and_use(std::size_t input, Sensed<SensorReading> sensed, Time now);

  /// To be called before a message is taken, which belongs to the new time.
  void check_clock(Time now) {
    if (!clock_.ran_back(now)) return;
    posed_.clear();
    forget_for_time_jump();
  }

  void forget_for_time_jump() {
    ++time_jumps_;
    if (options_.on_time_jump == OnTimeJump::reset) {
      remapper_.reset();
    } else {
      remapper_.freeze();
    }
    if (early_) take_early_correction();
  }

  void take_early_correction() {
    remapper_.correct(std::exchange(early_, std::nullopt)->correction);
  }

  SensorId sensor_id(std::size_t input, const std::string& frame) {
    const auto next = static_cast<SensorId>(sensors_.size());
    return sensors_.try_emplace({input, frame}, next).first->second;
  }

  struct EarlyCorrection {
    Correction correction;
    Time since;
  };
  static constexpr Duration kLead = seconds(1.0);  // by which others may notice a jump first

  PipelineOptions options_;
  FilterOf<Kind> filter_;
  PosedInput posed_;
  Remapper<Mapper> remapper_;
  ClockGuard clock_{seconds(0.1)};
  std::map<std::pair<std::size_t, std::string>, SensorId> sensors_;
  std::size_t time_jumps_ = 0;
  ClockGuard sender_clock_{seconds(0.1)};  // of those who correct
  std::size_t jumps_at_correction_ = 0;
  std::optional<EarlyCorrection> early_;
};

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
void Pipeline<Kind>::correct(Correction correction, Time stamp, Time now) {
  poll(now);
  const bool jumped = std::exchange(jumps_at_correction_, time_jumps_) != time_jumps_;
  const bool ran_back = sender_clock_.ran_back(stamp) && !jumped;
  if (early_) {
    early_->correction = std::move(correction);
  } else if (ran_back) {
    early_ = {std::move(correction), now};
  } else {
    remapper_.correct(std::move(correction));
  }
}

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
