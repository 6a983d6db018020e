// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/posed_input.hpp"

#include <console_bridge/console.h>
#include <tf2/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <utility>

#include "portolan_ros/convert/basics.hpp"
#include "portolan_ros/exact_tf.hpp"

namespace portolan {

namespace {

const char* const kAuthority = "portolan";

/// tf2 goes on with a line for each frame that it knows.
std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string tenths(double seconds) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.1f", seconds);
  return text;
}

/// Keeps tf2 from writing a line of log for each transform that it refuses: they are counted.
class SilentTf2 {
 public:
  SilentTf2() { console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_NONE); }
  ~SilentTf2() { console_bridge::setLogLevel(before_); }
  SilentTf2(const SilentTf2&) = delete;
  SilentTf2& operator=(const SilentTf2&) = delete;

 private:
  console_bridge::LogLevel before_ = console_bridge::getLogLevel();
};

bool is_well_formed(const geometry_msgs::TransformStamped& transform) {
  const std::string parent = ros_convert::without_slash(transform.header.frame_id);
  const std::string child = ros_convert::without_slash(transform.child_frame_id);
  return !parent.empty() && !child.empty() && parent != child &&
         is_valid(ros_convert::pose(transform.transform));
}

bool is_far_ahead(Time stamp, Time now) {
  return now != Time{} && stamp > now + std::chrono::hours(1);
}

}  // namespace

PosedInput::PosedInput(const PosedInputOptions& options)
    : options_(checked(options)),
      tf_(ros::Duration(options.tf_buffer)),
      covariances_(seconds(options.tf_buffer)) {
  options_.odom_frame = ros_convert::without_slash(options_.odom_frame);
}

std::size_t PosedInput::add_input(std::string noun) {
  tallies_.emplace_back(std::move(noun));
  order_.add_input();
  return tallies_.size() - 1;
}

void PosedInput::receive_malformed(std::size_t input) {
  tallies_[input].receive();
  tallies_[input].drop(Drop::malformed);
}

void PosedInput::receive_unposed(std::size_t input) {
  tallies_[input].receive();
  tallies_[input].use();
}

void PosedInput::receive(std::size_t input, Message message, Time now) {
  Tally& tally = tallies_[input];
  tally.receive();
  message.frame = ros_convert::without_slash(message.frame);
  if (message.first == Time{}) return tally.drop(Drop::no_stamp);
  if (is_repeated(input, message)) return tally.drop(Drop::repeated_stamp);
  order_.note(input, message.first);
  const auto order = [](const Waiting& w) { return std::make_pair(w.message.first, w.input); };
  Waiting waiting{input, std::move(message), now};
  const auto place =
      std::upper_bound(waiting_.begin(), waiting_.end(), waiting,
                       [&](const Waiting& a, const Waiting& b) { return order(a) < order(b); });
  waiting_.insert(place, std::move(waiting));
  poll(now);
  make_room();
}

void PosedInput::receive_tf(const tf2_msgs::TFMessage& message, bool is_static, Time now) {
  const SilentTf2 silence;
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    const bool good = is_well_formed(transform) && (is_static || is_timely(transform, now)) &&
                      tf_.setTransform(without_last_bits(transform), kAuthority, is_static);
    if (!good) ++bad_transforms_;
    if (good && !is_static) take_back_doubt(transform);
  }
}

void PosedInput::take_back_doubt(const geometry_msgs::TransformStamped& confirming) {
  const auto held = doubtful_.find(ros_convert::without_slash(confirming.child_frame_id));
  if (held == doubtful_.end()) return;
  const Duration apart =
      ros_convert::time(confirming.header.stamp) - ros_convert::time(held->second.header.stamp);
  const bool confirmed = std::abs(to_seconds(apart)) <= options_.tf_buffer;
  if (confirmed && tf_.setTransform(without_last_bits(held->second), kAuthority)) --bad_transforms_;
  doubtful_.erase(held);
}

void PosedInput::receive_odometry(const nav_msgs::Odometry& message, const std::string& base_frame,
                                  Time now) {
  geometry_msgs::TransformStamped transform;
  transform.header = message.header;
  if (transform.header.frame_id.empty()) transform.header.frame_id = options_.odom_frame;
  transform.child_frame_id = message.child_frame_id.empty() ? base_frame : message.child_frame_id;
  const geometry_msgs::Pose& pose = message.pose.pose;
  transform.transform.translation.x = pose.position.x;
  transform.transform.translation.y = pose.position.y;
  transform.transform.translation.z = pose.position.z;
  transform.transform.rotation = pose.orientation;
  tf2_msgs::TFMessage transforms;
  transforms.transforms.push_back(transform);
  receive_tf(transforms, false, now);
  const std::string child = ros_convert::without_slash(transform.child_frame_id);
  const bool is_odometry =
      ros_convert::without_slash(transform.header.frame_id) == options_.odom_frame;
  // Also where tf knows the pose from somebody else already; not where it was refused.
  if (is_odometry &&
      look_up(tf_, options_.odom_frame, child, ros_convert::time(message.header.stamp)))
    covariances_.receive(message, child);
}

void PosedInput::poll(Time now) { use_waiting(now, seconds(options_.order_wait)); }

void PosedInput::settle(Time now) { use_waiting(now, Duration::zero()); }

void PosedInput::use_waiting(Time now, Duration order_wait) {
  if (waiting_.empty()) return;
  for (Waiting& waiting : waiting_) {
    if (waiting.since == Time{}) waiting.since = now;  // it came before the first tick of /clock
  }
  const auto is_in_turn = [&](const Waiting& w) {
    return now - w.since >= order_wait || order_.is_in_turn(w.input, w.message.first);
  };
  // Where one is in turn, so are all before it.
  const auto last_in_turn = std::find_if(waiting_.rbegin(), waiting_.rend(), is_in_turn);
  auto turns = std::distance(last_in_turn, waiting_.rend());
  std::deque<Waiting> still_waiting;
  for (Waiting& waiting : waiting_) {
    const bool has_turn = turns-- > 0;
    if (has_turn && try_to_use(waiting)) continue;
    if (has_turn && now - waiting.since > seconds(options_.tf_wait)) {
      tallies_[waiting.input].drop(Drop::no_transform, why_not(waiting.message));
    } else {
      still_waiting.push_back(std::move(waiting));
    }
  }
  waiting_.swap(still_waiting);
}

bool PosedInput::transforms_ran_back() { return std::exchange(tf_ran_back_, false); }

void PosedInput::clear() {
  for (Waiting& waiting : std::exchange(waiting_, {})) {
    if (!try_to_use(waiting)) tallies_[waiting.input].drop(Drop::time_ran_back);
  }
  tf_.clear();
  covariances_.clear();
  seen_.clear();
  order_.clear();
  leap_guards_.clear();
  doubtful_.clear();
}

bool PosedInput::is_repeated(std::size_t input, const Message& message) {
  constexpr std::size_t kRemembered = 256;
  constexpr std::size_t kSensors = 1000;  // more make up a name for each message
  if (seen_.size() > kSensors) seen_.clear();
  auto& seen = seen_[{input, message.frame}];
  if (!seen.insert({message.first, message.part}).second) return true;
  if (seen.size() > kRemembered) seen.erase(seen.begin());
  return false;
}

bool PosedInput::try_to_use(Waiting& waiting) {
  const std::optional<SensorPose> pose = pose_of(waiting.message);
  if (!pose) return false;
  Tally& tally = tallies_[waiting.input];
  const std::optional<Outcome> outcome = waiting.message.use(*pose);
  if (!outcome) {
    tally.drop(Drop::thinned);
  } else if (*outcome == Outcome::inserted) {
    tally.use();
  } else {
    tally.drop(*outcome == Outcome::rejected ? Drop::rejected : Drop::unusable);
  }
  return true;
}

bool PosedInput::is_timely(const geometry_msgs::TransformStamped& transform, Time now) {
  const Time stamp = ros_convert::time(transform.header.stamp);
  if (stamp == Time{} || is_far_ahead(stamp, now)) return false;
  const std::string child = ros_convert::without_slash(transform.child_frame_id);
  const auto guard = leap_guards_.try_emplace(child, seconds(options_.tf_buffer)).first;
  const StampVerdict verdict = guard->second.judge(stamp);
  if (verdict == StampVerdict::doubtful) doubtful_[child] = transform;
  if (verdict == StampVerdict::ran_back) {
    tf_ran_back_ = true;
    auto doubtful = std::move(doubtful_);
    clear();  // tf2 would refuse the new transforms for being older than its memory
    doubtful_ = std::move(doubtful);
  }
  return verdict != StampVerdict::doubtful;
}

std::optional<PosedInput::SensorPose> PosedInput::pose_of(const Message& message) const {
  const std::string& odom = options_.odom_frame;
  const std::optional<Pose> first = look_up(tf_, odom, message.frame, message.first);
  if (!first) return std::nullopt;
  const std::optional<Pose> last =
      message.last == message.first ? first : look_up(tf_, odom, message.frame, message.last);
  if (!last) return std::nullopt;
  SensorPose pose{*first, first->inverse() * *last};
  pose.covariance = covariance_of(*first, message.first);
  for (const std::string& reference : message.references) {
    const std::optional<Pose> there = look_up(tf_, reference, message.frame, message.first);
    if (!there) return std::nullopt;
    pose.T_reference_sensor.push_back(*there);
  }
  return pose;
}

std::optional<PoseCovariance> PosedInput::covariance_of(const Pose& T_odom_sensor,
                                                        Time stamp) const {
  const std::optional<OdometryCovariances::Stated> stated = covariances_.at(stamp);
  if (!stated) return std::nullopt;
  const std::optional<Pose> T_odom_base = look_up(tf_, options_.odom_frame, stated->frame, stamp);
  if (!T_odom_base) return std::nullopt;
  const Eigen::Vector3d arm = T_odom_sensor.translation() - T_odom_base->translation();
  return turned(carried(stated->covariance, arm), T_odom_sensor.linear().transpose());
}

std::string PosedInput::missing_target(const Message& message) const {
  const auto is_missing = [&](const std::string& target) {
    return !look_up(tf_, target, message.frame, message.first) ||
           !look_up(tf_, target, message.frame, message.last);
  };
  if (is_missing(options_.odom_frame)) return options_.odom_frame;
  const auto found = std::find_if(message.references.begin(), message.references.end(), is_missing);
  return found == message.references.end() ? options_.odom_frame : *found;
}

std::string PosedInput::why_not(const Message& message) const {
  if (!ros_convert::is_frame_name(message.frame)) return "they name no frame";
  const std::string target = missing_target(message);
  const std::string arrow = target + " <- " + message.frame;
  for (const std::string& frame : {target, message.frame}) {
    if (!tf_._frameExists(frame)) return "no transform " + arrow + ": tf knows no frame " + frame;
  }
  try {
    const ros::Time newest = tf_.lookupTransform(target, message.frame, ros::Time(0)).header.stamp;
    const double gap = to_seconds(message.last - ros_convert::time(newest));
    return "no transform " + arrow + " at their stamps; newest is " + tenths(std::abs(gap)) +
           (gap >= 0.0 ? " s older" : " s newer");
  } catch (const tf2::TransformException& error) {
    return "no transform " + arrow + ": " + first_line(error.what());
  }
}

void PosedInput::make_room() {
  while (waiting_.size() > static_cast<std::size_t>(options_.queue_size)) {
    Waiting oldest = std::move(waiting_.front());
    waiting_.pop_front();
    if (!try_to_use(oldest)) {
      tallies_[oldest.input].drop(Drop::queue_full, why_not(oldest.message));
    }
  }
}

}  // namespace portolan
