// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

#include "portolan_ros/kinds/for_each_kind.hpp"
#include "portolan_ros/node_options.hpp"
#include "portolan_ros/report.hpp"

namespace {

using portolan::OptionRow;

std::string indented(const std::string& yaml) {
  std::string text;
  bool line_begins = true;
  for (const char c : yaml) {
    if (line_begins) text += "  ";
    text += c;
    line_begins = c == '\n';
  }
  return text;
}

void write_config(const std::filesystem::path& file, const std::string& name,
                  const std::vector<OptionRow>& rows) {
  std::ofstream out(file);
  out << "# All parameters of the node " << name
      << ", with their defaults. Made by scripts/generate.\n"
      << name << ":\n"
      << indented(to_yaml(rows));
  if (!out.flush()) throw std::runtime_error("can't write " + file.string());
}

}  // namespace

/// Writes a YAML file of defaults for each mapper into a folder, and their tables to stdout.
int main(int argc, char** argv) try {
  if (argc != 2) throw std::invalid_argument("usage: options_docs CONFIG_FOLDER > parameters.md");
  const std::filesystem::path folder = argv[1];
  portolan::for_each_kind([&folder](auto kind) {
    using Kind = decltype(kind);
    const portolan::MapperNodeOptions<Kind> defaults;
    const std::string name = Kind::kName;
    write_config(folder / (name + ".yaml"), name, option_rows(defaults));
    std::cout << "\n## " << name << "\n\n" << to_markdown(option_rows(defaults));
  });
  return 0;
} catch (const std::exception& error) {
  return portolan::report(error);
}
