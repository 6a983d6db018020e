// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "portolan_ros/kinds/beacon_kind.hpp"
#include "portolan_ros/kinds/grid_kind.hpp"
#include "portolan_ros/kinds/landmark_kind.hpp"
#include "portolan_ros/kinds/octo_kind.hpp"

namespace portolan {

/// Calls the function with each kind of map, in the order in which maps are made and documented.
template <class Function>
void for_each_kind(Function function) {
  function(GridKind{});
  function(OctoKind{});
  function(LandmarkKind{});
  function(BeaconKind{});
}

}  // namespace portolan
