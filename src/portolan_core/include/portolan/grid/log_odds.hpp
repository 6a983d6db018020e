// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "portolan/grid/grid_options.hpp"

namespace portolan {

/// The byte of a cell: its log-odds in quanta plus 128; 0 says that nobody has observed it.
using CellByte = std::uint8_t;

inline constexpr CellByte kNeverObserved = 0;

/// What one observation does to the bytes of the cells in R_f and R_o: Eq. 7, saturating.
/// A free cell becomes max(byte, free_floor) - free_step, an occupied one
/// min(byte, occupied_ceiling) + occupied_step.
struct CellUpdate {
  CellByte prior = 0;
  CellByte free_floor = 0;
  CellByte free_step = 0;
  CellByte occupied_ceiling = 0;
  CellByte occupied_step = 0;
};

/// Translates between probabilities and the bytes of cells.
class LogOdds {
 public:
  /// The options must be good.
  explicit LogOdds(const GridOptions& options);

  /// Eq. 7 with the model's inverse probabilities: l_t = l_{t-1} + tau - l_0.
  CellUpdate update(const InverseSensorModel& model) const;

  /// P(occupied), Eq. 8; not for kNeverObserved.
  double probability(CellByte cell) const { return probability_[cell]; }

  /// The byte nearest to this probability within p_min and p_max.
  CellByte byte(double probability) const;

  CellByte min() const { return min_; }
  CellByte max() const { return max_; }
  CellByte prior() const { return prior_; }

 private:
  double quantum_;
  CellByte min_;
  CellByte max_;
  CellByte prior_;
  std::array<double, 256> probability_;
};

}  // namespace portolan
