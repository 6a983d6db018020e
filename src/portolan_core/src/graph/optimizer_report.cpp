// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/optimizer_report.hpp"

namespace portolan {

std::string to_string(const std::set<Doubt>& doubts) {
  std::string text;
  for (const Doubt doubt : doubts) {
    text += (text.empty() ? "" : ", ");
    text += enum_names(doubt)[static_cast<std::size_t>(doubt)];
  }
  return text.empty() ? "none" : text;
}

}  // namespace portolan
