// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>

#include "portolan/map_file.hpp"
#include "portolan/remapper.hpp"
#include "portolan_ros/map_services.hpp"
#include "portolan_ros/mapper_node_options.hpp"

namespace portolan {

/// Keeps a map in files, and begins again from files or from nothing. Each action says in a
/// sentence what it did, and throws where it can't; then map and files are as before.
template <class Kind>
class MapKeeper {
 public:
  using Mapper = typename Kind::Mapper;

  /// `name` is asked for at each action: users may rename the map between two saves.
  MapKeeper(Remapper<Mapper>& remapper, const MapperNodeOptions<Kind>& options,
            std::function<std::string()> name)
      : remapper_(remapper), options_(options), name_(std::move(name)) {}

  std::string save() {
    const std::string name = checked_map_name(name_());
    remapper_.finish();
    return keep_files(options_.node.map_directory, Kind::save(remapper_.map(), name, options_));
  }

  std::string load() {
    const std::filesystem::path folder = folder_of(options_.node.map_directory);
    const std::string name = checked_map_name(name_());
    remapper_.restart_from(Kind::load(folder, name, options_));
    return "loaded " + name + " from " + folder.string();
  }

  std::string reset() {
    remapper_.restart_from(Mapper(options_.mapper));
    return "the map is empty";
  }

 private:
  Remapper<Mapper>& remapper_;
  const MapperNodeOptions<Kind>& options_;
  std::function<std::string()> name_;
};

}  // namespace portolan
