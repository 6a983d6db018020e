// SPDX-License-Identifier: BSD-3-Clause
#include "open_bags.hpp"

#include <rosbag/view.h>

#include <boost/algorithm/string/join.hpp>
#include <filesystem>
#include <map>
#include <sstream>
#include <stdexcept>

#include "portolan_ros/convert/basics.hpp"

namespace portolan {

namespace {

/// The sensors' topics of the bags as the command line would name them.
std::string advice_on(const std::vector<const rosbag::ConnectionInfo*>& connections) {
  static const std::map<std::string, std::string> kInputs{
      {"sensor_msgs/LaserScan", "scan"},
      {"sensor_msgs/Range", "sonar"},
      {"sensor_msgs/PointCloud2", "cloud_in"},
      {"portolan_msgs/LandmarkSightings", "landmark_sightings"},
      {"portolan_msgs/ImageFeatures", "image_features"},
      {"portolan_msgs/BeaconRanges", "beacon_ranges"}};
  std::set<std::string> words;
  for (const rosbag::ConnectionInfo* connection : connections) {
    const auto input = kInputs.find(connection->datatype);
    if (input != kInputs.end()) words.insert(input->second + ":=" + connection->topic);
  }
  if (words.empty()) return "they hold no message of a kind that is mapped";
  return "they hold topics for which you can say " + boost::join(words, " ");
}

/// Throws std::invalid_argument unless some of the recording lies in the time that is wanted.
void check_time(double start, std::optional<double> duration, double lasts) {
  const bool holds = start >= 0.0 && start <= lasts && duration.value_or(1.0) > 0.0;
  if (holds) return;
  std::ostringstream text;
  text << "the bags last " << lasts << " s: --start must lie in them, and --duration be above 0";
  throw std::invalid_argument(text.str());
}

void open(const std::string& path, Bags& bags) {
  if (!std::filesystem::exists(path)) throw std::runtime_error(path + ": there is no such file");
  if (std::filesystem::is_directory(path)) throw std::runtime_error(path + ": is a folder, no bag");
  try {
    bags.open.emplace_back(path);
  } catch (const rosbag::BagException& error) {
    throw std::runtime_error(path + ": is no whole bag (" + error.what() +
                             "); `rosbag reindex` mends one whose end is missing");
  }
}

}  // namespace

Bags open_bags(const std::vector<std::string>& paths, double start,
               std::optional<double> duration) {
  Bags bags;
  rosbag::View all;
  for (const std::string& path : paths) {
    open(path, bags);
    all.addQuery(bags.open.back());
  }
  if (all.size() == 0) throw std::runtime_error("the bags hold no messages");
  check_time(start, duration, (all.getEndTime() - all.getBeginTime()).toSec());
  bags.begin = all.getBeginTime() + ros::Duration(start);
  bags.end = duration ? bags.begin + ros::Duration(*duration) : all.getEndTime();
  for (const rosbag::ConnectionInfo* connection : all.getConnections()) {
    bags.topics.insert(ros_convert::without_slash(connection->topic));
  }
  bags.advice = advice_on(all.getConnections());
  return bags;
}

}  // namespace portolan
