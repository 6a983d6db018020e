// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

#include "portolan_ros/health.hpp"

namespace portolan {

/// Messages, used, and dropped by reason, for each input, under its noun.
YAML::Node counts_of(const std::vector<Tally>& tallies);

/// The sentences of the inputs that received something.
std::string sentence_of(const std::vector<Tally>& tallies);

/// True where any input used a message.
bool used_anything(const std::vector<Tally>& tallies);

}  // namespace portolan
