// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <rosbag/bag.h>

#include <list>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace portolan {

/// The bags, opened, and how their time runs.
struct Bags {
  std::list<rosbag::Bag> open;
  ros::Time begin;
  ros::Time end;
  std::set<std::string> topics;  ///< without their slashes
  std::string advice;            ///< how to name the sensors' topics on the command line
};

/// Opens the bags at these paths, of which only `duration` [s] from `start` [s] on is wanted.
/// Throws std::exception with the path of a bag at fault, or where nothing lies in that time.
Bags open_bags(const std::vector<std::string>& paths, double start, std::optional<double> duration);

}  // namespace portolan
