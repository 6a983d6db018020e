// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/posed_input.hpp"

#include <tf2/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "portolan_ros/convert/basics.hpp"

namespace portolan {

namespace {

const char* const kAuthority = "portolan";

std::string tenths(double seconds) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.1f", seconds);
  return text;
}

/// What tf2 would refuse with a line of log for each one.
bool is_well_formed(const geometry_msgs::TransformStamped& transform) {
  const std::string parent = ros_convert::without_slash(transform.header.frame_id);
  const std::string child = ros_convert::without_slash(transform.child_frame_id);
  return !parent.empty() && !child.empty() && parent != child &&
         is_valid(ros_convert::pose(transform.transform));
}

/// One wild stamp must not pass for the newest: all that follows would seem to run back.
bool is_far_ahead(const geometry_msgs::TransformStamped& transform, Time now) {
  return now != Time{} && ros_convert::time(transform.header.stamp) > now + std::chrono::hours(1);
}

}  // namespace

PosedInput::PosedInput(const PosedInputOptions& options)
    : options_(checked(options)),
      tf_(ros::Duration(options.tf_buffer)),
      tf_clock_(seconds(options.tf_buffer)) {
  options_.odom_frame = ros_convert::without_slash(options_.odom_frame);
}

std::size_t PosedInput::add_input(std::string noun) {
  tallies_.emplace_back(std::move(noun));
  return tallies_.size() - 1;
}

void PosedInput::receive_malformed(std::size_t input) {
  tallies_[input].receive();
  tallies_[input].drop(Drop::malformed);
}

void PosedInput::receive(std::size_t input, Message message, Time now) {
  Tally& tally = tallies_[input];
  tally.receive();
  message.frame = ros_convert::without_slash(message.frame);
  if (message.first == Time{}) return tally.drop(Drop::no_stamp);
  if (is_repeated(input, message)) return tally.drop(Drop::repeated_stamp);
  const auto place = std::upper_bound(waiting_.begin(), waiting_.end(), message.first,
                                      [](Time t, const Waiting& w) { return t < w.message.first; });
  waiting_.insert(place, Waiting{input, std::move(message), now});
  poll(now);
  make_room();
}

void PosedInput::receive_tf(const tf2_msgs::TFMessage& message, bool is_static, Time now) {
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    const bool good = is_well_formed(transform) && !is_far_ahead(transform, now);
    if (good && !is_static) note_time_of(transform);
    if (!good || !tf_.setTransform(transform, kAuthority, is_static)) ++bad_transforms_;
  }
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
}

void PosedInput::poll(Time now) {
  std::deque<Waiting> still_waiting;
  for (Waiting& waiting : waiting_) {
    if (waiting.since == Time{}) waiting.since = now;  // it came before the first tick of /clock
    if (try_to_use(waiting)) continue;
    if (now - waiting.since > seconds(options_.tf_wait)) {
      tallies_[waiting.input].drop(Drop::no_transform, why_not(waiting.message));
    } else {
      still_waiting.push_back(std::move(waiting));
    }
  }
  waiting_.swap(still_waiting);
}

bool PosedInput::transforms_ran_back() { return std::exchange(tf_ran_back_, false); }

void PosedInput::clear() {
  tf_.clear();
  for (const Waiting& waiting : waiting_) tallies_[waiting.input].drop(Drop::time_ran_back);
  waiting_.clear();
  newest_.clear();
}

bool PosedInput::is_repeated(std::size_t input, const Message& message) {
  const auto [newest, is_first] = newest_.try_emplace({input, message.frame}, message.first);
  if (is_first) return false;
  const bool repeated = newest->second == message.first;
  newest->second = message.first;
  return repeated;
}

bool PosedInput::try_to_use(Waiting& waiting) {
  const Message& message = waiting.message;
  const std::optional<Pose> first = look_up(message.frame, message.first);
  if (!first) return false;
  const std::optional<Pose> last =
      message.last == message.first ? first : look_up(message.frame, message.last);
  if (!last) return false;
  Tally& tally = tallies_[waiting.input];
  const std::optional<Outcome> outcome = message.use({*first, first->inverse() * *last});
  if (!outcome) {
    tally.drop(Drop::thinned);
  } else if (*outcome == Outcome::inserted) {
    tally.use();
  } else {
    tally.drop(*outcome == Outcome::rejected ? Drop::rejected : Drop::unusable);
  }
  return true;
}

void PosedInput::note_time_of(const geometry_msgs::TransformStamped& transform) {
  if (!tf_clock_.ran_back(ros_convert::time(transform.header.stamp))) return;
  tf_ran_back_ = true;
  clear();  // tf2 would refuse the new transforms for being older than its memory
}

std::optional<Pose> PosedInput::look_up(const std::string& frame, Time stamp) const {
  try {
    const ros::Time time = ros_convert::time(stamp);
    return ros_convert::pose(tf_.lookupTransform(options_.odom_frame, frame, time).transform);
  } catch (const tf2::TransformException&) {
    return std::nullopt;
  }
}

std::string PosedInput::why_not(const Message& message) const {
  const std::string& odom = options_.odom_frame;
  const std::string arrow = odom + " <- " + message.frame;
  try {
    const ros::Time newest = tf_.lookupTransform(odom, message.frame, ros::Time(0)).header.stamp;
    const double gap = to_seconds(message.last - ros_convert::time(newest));
    return "no transform " + arrow + " at their stamps; newest is " + tenths(std::abs(gap)) +
           (gap >= 0.0 ? " s older" : " s newer");
  } catch (const tf2::TransformException& error) {
    return "no transform " + arrow + ": " + error.what();
  }
}

void PosedInput::make_room() {
  while (waiting_.size() > static_cast<std::size_t>(options_.queue_size)) {
    tallies_[waiting_.front().input].drop(Drop::queue_full, why_not(waiting_.front().message));
    waiting_.pop_front();
  }
}

}  // namespace portolan
