// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "portolan_ros/clock_guard.hpp"
#include "portolan_ros/convert/basics.hpp"
#include "portolan_ros/correction_gate.hpp"
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
    apply(correction_gate_.overdue(now));
  }

  /// Uses what waits for messages of other topics, since none are coming for now.
  void settle(Time now) { posed_.settle(now); }

  /// Takes a correction that its sender worked out at `stamp`; see CorrectionGate.
  void correct(Correction correction, Time stamp, Time now) {
    poll(now);
    apply(correction_gate_.take(std::move(correction), stamp, now));
  }

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
    apply(correction_gate_.clock_ran_back());
  }

  void apply(std::optional<Correction> correction) {
    if (correction) remapper_.correct(std::move(*correction));
  }

  SensorId sensor_id(std::size_t input, const std::string& frame) {
    const auto next = static_cast<SensorId>(sensors_.size());
    return sensors_.try_emplace({input, frame}, next).first->second;
  }

  PipelineOptions options_;
  FilterOf<Kind> filter_;
  PosedInput posed_;
  Remapper<Mapper> remapper_;
  ClockGuard clock_{seconds(0.1)};
  CorrectionGate correction_gate_;
  std::map<std::pair<std::size_t, std::string>, SensorId> sensors_;
  std::size_t time_jumps_ = 0;
};

}  // namespace portolan

#include "portolan_ros/pipeline_impl.hpp"  // IWYU pragma: export
