// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace portolan {

/// What became of an observation that was offered to a mapper.
enum class Outcome {
  inserted,  ///< it is in the map
  rejected,  ///< fine in itself, but not from this pose
  unusable,  ///< malformed: no pose would make it usable
};

constexpr std::array<const char*, 3> enum_names(Outcome) {
  return {"inserted", "rejected", "unusable"};
}

}  // namespace portolan
