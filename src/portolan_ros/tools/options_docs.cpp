// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "portolan_ros/graph/graph_node_options.hpp"
#include "portolan_ros/kinds/for_each_kind.hpp"
#include "portolan_ros/mapper_node_options.hpp"
#include "portolan_ros/options_page.hpp"
#include "portolan_ros/report.hpp"

namespace {

constexpr const char* kUsage =
    "usage: options_docs CONFIG_FOLDER > parameters.md\n"
    "Writes a YAML file of defaults for each mapper into a folder, and their tables to stdout.\n";

}  // namespace

int main(int argc, char** argv) try {
  if (const auto code = portolan::exit_with_usage(argc, argv, 1, 1, kUsage)) return *code;
  const std::string folder = argv[1];
  portolan::for_each_kind([&folder](auto kind) {
    using Kind = decltype(kind);
    const portolan::MapperNodeOptions<Kind> defaults;
    portolan::document(folder, Kind::kName, option_rows(defaults));
  });
  portolan::document(folder, "pose_graph", option_rows(portolan::GraphNodeOptions{}));
  return 0;
} catch (const std::exception& error) {
  return portolan::report(error);
}
