// SPDX-License-Identifier: BSD-3-Clause
#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <stdexcept>
#include <type_traits>

#include "portolan_ros/kinds/for_each_kind.hpp"
#include "portolan_ros/report.hpp"

namespace {

using namespace portolan;

template <class Options, class = void>
constexpr bool kHasResolution = false;
template <class Options>
constexpr bool kHasResolution<Options, std::void_t<decltype(Options::resolution)>> = true;

/// The pictures of a saved map of this kind, whatever its resolution; none where there is no map.
template <class Kind>
FileSet pictures_of(const std::filesystem::path& folder) {
  const std::filesystem::path yaml = folder / (std::string(Kind::kFileName) + ".yaml");
  if (!std::filesystem::exists(yaml)) return {};
  MapperNodeOptions<Kind> options;
  if constexpr (kHasResolution<typename Kind::Mapper::Options>) {
    options.mapper.resolution = YAML::LoadFile(yaml.string())["resolution"].as<double>();
  }
  return Kind::pictures(Kind::load(folder, Kind::kFileName, options), Kind::kFileName, {});
}

constexpr const char* kUsage =
    "usage: draw_maps FOLDER OUT_FOLDER\n"
    "Draws the maps that nodes have saved into a folder, one picture for each.\n";

}  // namespace

int main(int argc, char** argv) try {
  if (const auto code = exit_with_usage(argc, argv, 2, 2, kUsage)) return *code;
  FileSet pictures;
  for_each_kind([&](auto kind) { pictures.merge(pictures_of<decltype(kind)>(argv[1])); });
  if (pictures.empty()) throw std::runtime_error(std::string(argv[1]) + ": holds no maps");
  std::filesystem::create_directories(argv[2]);
  save_files(argv[2], pictures);
  return 0;
} catch (const std::exception& error) {
  return portolan::report(error);
}
