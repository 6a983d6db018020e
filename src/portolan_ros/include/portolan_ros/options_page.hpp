// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "portolan/options.hpp"

namespace portolan {

/// A node's parameters as the YAML file of its defaults: all under the node's name.
std::string config_file(const std::string& node, const std::vector<OptionRow>& rows);

/// The same as a section of the Markdown page of parameters.
std::string page_section(const std::string& node, const std::vector<OptionRow>& rows);

/// Writes `<node>.yaml` into the folder and the section to stdout. Throws std::runtime_error where
/// the file can't be written.
void document(const std::string& folder, const std::string& node,
              const std::vector<OptionRow>& rows);

}  // namespace portolan
