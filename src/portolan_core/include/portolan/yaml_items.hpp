// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <functional>
#include <string>

namespace portolan::yaml_values {

/// Takes one item of a list, given what stands before the list in its file.
using TakeItem = std::function<void(const YAML::Node& head, const YAML::Node& item)>;

/// Reads a file of a map: keys, and under the key `list` as many items as there may be, each given
/// to `take` and then forgotten, since YAML in memory takes a hundred times the room of its text.
/// Gives the keys back, the list among them without its items. Throws std::runtime_error where it
/// is no YAML, and for what no map needs: anchors, over 32 levels, a million values in one item.
YAML::Node read_items(const std::string& text, const std::string& list, const TakeItem& take);

}  // namespace portolan::yaml_values
