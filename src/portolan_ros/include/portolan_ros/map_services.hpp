// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <std_srvs/Trigger.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "portolan/map_file.hpp"

namespace portolan {

/// Save, load and reset as services. What goes wrong becomes `success: false` and the reason.
class MapServices {
 public:
  /// Each does its work, says in a sentence what it did, and throws where it can't.
  struct Actions {
    std::function<std::string()> save;
    std::function<std::string()> load;
    std::function<std::string()> reset;
  };

  MapServices(ros::NodeHandle& private_handle, Actions actions);
  MapServices(const MapServices&) = delete;  // the services call back into this object
  MapServices& operator=(const MapServices&) = delete;

 private:
  Actions actions_;
  std::vector<ros::ServiceServer> servers_;
};

/// The folder that a parameter names: "~/" is the user's home.
std::filesystem::path folder_of(const std::string& map_directory);

/// Keeps a map's files in that folder, all of them or none, and says so in a sentence. Throws
/// std::runtime_error where there are none, since nothing has been observed: what an earlier run
/// left there is worth more.
std::string keep_files(const std::string& map_directory, const FileSet& files);

/// The name itself. Throws std::invalid_argument where it is no bare file name: anyone on the ROS
/// network can set it and call a service.
const std::string& checked_map_name(const std::string& name);

}  // namespace portolan
