// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/map_services.hpp"

#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <utility>

namespace portolan {

namespace {

using Trigger = std_srvs::Trigger;

/// The answer to a call: what the action says, or why it could not.
bool answer(const std::function<std::string()>& action, Trigger::Response& response) {
  try {
    response.message = action();
    response.success = true;
  } catch (const std::exception& error) {
    response.message = error.what();
    response.success = false;
  }
  return true;
}

}  // namespace

MapServices::MapServices(ros::NodeHandle& private_handle, Actions actions)
    : actions_(std::move(actions)) {
  const auto offer = [&](const std::string& name, const std::function<std::string()>& action) {
    const boost::function<bool(Trigger::Request&, Trigger::Response&)> callback =
        [&action](Trigger::Request&, Trigger::Response& response) {
          return answer(action, response);
        };
    servers_.push_back(private_handle.advertiseService(name, callback));
  };
  offer("save", actions_.save);
  offer("load", actions_.load);
  offer("reset", actions_.reset);
}

std::filesystem::path folder_of(const std::string& map_directory) {
  if (map_directory != "~" && map_directory.rfind("~/", 0) != 0) return map_directory;
  const char* home = std::getenv("HOME");
  if (home == nullptr || *home == '\0') {
    throw std::runtime_error("map_directory names the home, but HOME is unset");
  }
  return std::filesystem::path(home) / map_directory.substr(map_directory.size() > 1 ? 2 : 1);
}

std::string keep_files(const std::string& map_directory, const FileSet& files) {
  if (files.empty()) throw std::runtime_error("nothing has been observed yet");
  const std::filesystem::path folder = folder_of(map_directory);
  std::filesystem::create_directories(folder);
  save_files(folder, files);
  std::string names;
  for (const auto& [file, content] : files) names += " " + file;
  return "saved" + names + " in " + folder.string();
}

const std::string& checked_map_name(const std::string& name) {
  if (!is_bare_name(name)) {
    throw std::invalid_argument("map_name \"" + name + "\" is no bare file name");
  }
  return name;
}

}  // namespace portolan
