// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/options/write.hpp"

namespace portolan {

namespace {

std::vector<std::string> split(const std::string& name) {
  std::vector<std::string> parts(1);
  for (const char c : name) {
    if (c == '/') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

std::string escaped(const std::string& text) {
  std::string all;
  for (const char c : text) {
    if (c == '|') all += '\\';
    all += c;
  }
  return all;
}

std::string comment(const OptionRow& row) {
  return row.meaning + (row.allowed.empty() ? "" : "; " + row.allowed);
}

}  // namespace

std::string to_yaml(const std::vector<OptionRow>& rows) {
  std::string yaml;
  std::vector<std::string> open;  // the groups that the last line stands in
  for (const OptionRow& row : rows) {
    const std::vector<std::string> parts = split(row.name);
    std::size_t common = 0;
    while (common < open.size() && common + 1 < parts.size() && open[common] == parts[common]) {
      ++common;
    }
    for (std::size_t depth = common; depth + 1 < parts.size(); ++depth) {
      yaml += std::string(2 * depth, ' ') + parts[depth] + ":\n";
    }
    open.assign(parts.begin(), parts.end() - 1);
    yaml += std::string(2 * open.size(), ' ') + parts.back() + ": " + row.value + "  # " +
            comment(row) + "\n";
  }
  return yaml;
}

std::string to_markdown(const std::vector<OptionRow>& rows) {
  std::string table = "| parameter | type | default | allowed | meaning |\n|---|---|---|---|---|\n";
  for (const OptionRow& row : rows) {
    table += "| `" + row.name + "` | " + escaped(row.type) + " | `" + escaped(row.value) + "` | " +
             row.allowed + " | " + escaped(row.meaning) + " |\n";
  }
  return table;
}

}  // namespace portolan
