// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Options are plain structs that are described once: name, field, meaning with unit, interval.
//
//   struct Options {
//     double resolution = 0.05;
//     template <class Self, class Visitor>
//     static void describe(Self& self, Visitor& visit) {
//       visit("resolution", self.resolution, "side of a cell [m]", above(0.0));
//       visit.require(self.resolution < 1.0, "resolution must be below a metre");
//     }
//   };
//
// Fields are bool, numbers, std::string, enums with `enum_names` beside them (a constexpr function
// that gives the names of the enumerators in order), structs that are described themselves, and
// std::vector of all these. Whoever reads, checks, writes or documents options visits that list.

#include "portolan/options/check.hpp"     // IWYU pragma: export
#include "portolan/options/error.hpp"     // IWYU pragma: export
#include "portolan/options/interval.hpp"  // IWYU pragma: export
#include "portolan/options/read.hpp"      // IWYU pragma: export
#include "portolan/options/write.hpp"     // IWYU pragma: export
