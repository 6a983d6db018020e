// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/options_page.hpp"

#include <fstream>
#include <iostream>
#include <stdexcept>

namespace portolan {

namespace {

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

}  // namespace

std::string config_file(const std::string& node, const std::vector<OptionRow>& rows) {
  return "# All parameters of the node " + node +
         ", with their defaults. Made by scripts/generate.\n" + node + ":\n" +
         indented(to_yaml(rows));
}

std::string page_section(const std::string& node, const std::vector<OptionRow>& rows) {
  return "\n## " + node + "\n\n" + to_markdown(rows);
}

void document(const std::string& folder, const std::string& node,
              const std::vector<OptionRow>& rows) {
  const std::string file = folder + "/" + node + ".yaml";
  std::ofstream out(file);
  out << config_file(node, rows);
  if (!out.flush()) throw std::runtime_error("can't write " + file);
  std::cout << page_section(node, rows);
}

}  // namespace portolan
