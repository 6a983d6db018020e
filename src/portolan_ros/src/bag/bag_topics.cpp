// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/bag/bag_topics.hpp"

namespace portolan {

std::set<std::string> BagTopics::names() const {
  std::set<std::string> all;
  for (const auto& [topic, handlers] : handlers_) all.insert(topic);
  return all;
}

void BagTopics::take(const rosbag::MessageInstance& message) {
  const auto found = handlers_.find(ros_convert::without_slash(message.getTopic()));
  if (found == handlers_.end()) return;
  const auto start = std::chrono::steady_clock::now();
  newest_ = ros_convert::time(message.getTime());
  for (const Handler& handler : found->second) handler(message, newest_);
  wall_time_ += std::chrono::steady_clock::now() - start;
}

}  // namespace portolan
