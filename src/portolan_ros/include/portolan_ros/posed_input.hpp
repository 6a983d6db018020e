// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/Odometry.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "portolan/outcome.hpp"
#include "portolan/pose.hpp"
#include "portolan/time.hpp"
#include "portolan_ros/health.hpp"
#include "portolan_ros/input_order.hpp"
#include "portolan_ros/leap_guard.hpp"
#include "portolan_ros/odometry_covariances.hpp"
#include "portolan_ros/posed_input_options.hpp"

namespace portolan {

/// Tells where the sensor was for each message: messages wait here until tf knows, and are
/// dropped with a reason where it does not say in time. Never is anything posed by guess.
///
/// Knows no ROS graph and no clock: whoever owns it hands in messages and the time, so it works
/// the same on a live robot and over a bag.
class PosedInput {
 public:
  /// Where the sensor was when its measurement began, and how it moved until the end of it.
  struct SensorPose {
    Pose T_odom_sensor;
    Pose T_first_last;
    std::vector<Pose> T_reference_sensor = {};  ///< at the begin, for each of the references
    /// Of T_odom_sensor, along and about the sensor's axes, where odometry states it.
    std::optional<PoseCovariance> covariance = std::nullopt;
  };
  /// Called with the pose once it is known. None: thinned.
  using Use = std::function<std::optional<Outcome>(const SensorPose&)>;

  struct Message {
    std::string frame;
    Time first;
    Time last;
    Use use;
    std::vector<std::string> references = {};  ///< further frames that it has to be posed in
    std::uint64_t part = 0;                    ///< of what the sensor says at that moment
  };

  explicit PosedInput(const PosedInputOptions& options);

  /// Opens an input whose messages are called by `noun`; the number names it from then on.
  std::size_t add_input(std::string noun);

  /// A message that could not be converted.
  void receive_malformed(std::size_t input);

  /// A message that was used and needs no pose.
  void receive_unposed(std::size_t input);

  /// A message: used at once where tf is there and it is its turn, else by `poll`, later.
  void receive(std::size_t input, Message message, Time now);

  /// Takes transforms. Malformed and repeated ones, moving ones without a stamp, and stamps over
  /// an hour ahead are counted and left out; so is a lone stamp that leaps away from those before
  /// it by more than is remembered. Where a second one leaps to the same time, both count; if that
  /// lies back, as when a bag loops without a clock, it starts to remember anew.
  void receive_tf(const tf2_msgs::TFMessage& message, bool is_static, Time now);

  /// Takes odometry as a transform, for robots that send no tf, and what it says of its own
  /// uncertainty. Empty frames are filled in.
  void receive_odometry(const nav_msgs::Odometry& message, const std::string& base_frame, Time now);

  /// Uses what can be posed now, by stamp, then by input, and drops what has waited too long.
  void poll(Time now);

  /// The same where nothing more is coming for now, as at the end of a bag: none waits for others.
  void settle(Time now);

  /// True once after stamps of transforms ran back.
  bool transforms_ran_back();

  /// Uses what waits and can be posed; then forgets the rest and the transforms that move. Static
  /// ones stay.
  void clear();

  const std::vector<Tally>& tallies() const { return tallies_; }
  std::size_t bad_transforms() const { return bad_transforms_; }
  const tf2::BufferCore& tf() const { return tf_; }

 private:
  struct Waiting {
    std::size_t input;
    Message message;
    Time since;
  };

  void use_waiting(Time now, Duration order_wait);
  bool is_timely(const geometry_msgs::TransformStamped& transform, Time now);
  void take_back_doubt(const geometry_msgs::TransformStamped& confirming);
  bool is_repeated(std::size_t input, const Message& message);
  bool try_to_use(Waiting& waiting);
  std::optional<SensorPose> pose_of(const Message& message) const;
  std::optional<PoseCovariance> covariance_of(const Pose& T_odom_sensor, Time stamp) const;
  std::string missing_target(const Message& message) const;
  std::string why_not(const Message& message) const;
  void make_room();

  PosedInputOptions options_;
  tf2::BufferCore tf_;
  OdometryCovariances covariances_;
  std::map<std::string, LeapGuard> leap_guards_;                     // by child frame
  std::map<std::string, geometry_msgs::TransformStamped> doubtful_;  // likewise: the last leap
  bool tf_ran_back_ = false;
  std::vector<Tally> tallies_;
  // Stamps and parts by input and frame.
  std::map<std::pair<std::size_t, std::string>, std::set<std::pair<Time, std::uint64_t>>> seen_;
  std::deque<Waiting> waiting_;  // by stamp, then by input, then by arrival
  InputOrder order_;
  std::size_t bad_transforms_ = 0;
};

}  // namespace portolan
