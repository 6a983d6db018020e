// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "portolan/grid/grid_layer.hpp"
#include "portolan/grid/log_odds.hpp"

namespace portolan {

/// One cell in each layer, kNeverObserved where the layer does not know it.
using CellStack = std::array<CellByte, kGridLayers.size()>;

/// Makes one byte of a cell's layers; kNeverObserved where no layer observed it. `latest` is 1 +
/// the layer that observed the cell last, 0 where that is not known.
CellByte fuse(Fusion fusion, const LogOdds& log_odds, const CellStack& stack, CellByte latest);

}  // namespace portolan
