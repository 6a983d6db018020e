// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/fuse.hpp"

#include <algorithm>

namespace portolan {

namespace {

CellByte most_occupied(const CellStack& stack) {
  return *std::max_element(stack.begin(), stack.end());  // kNeverObserved is below all others
}

// Eq. 7 with a layer's evidence in place of an observation's: every layer starts at the prior,
// which may count once only.
CellByte sum(const LogOdds& log_odds, const CellStack& stack) {
  int sum = log_odds.prior();
  for (CellByte cell : stack) {
    if (cell != kNeverObserved) sum += cell - log_odds.prior();
  }
  return static_cast<CellByte>(std::clamp<int>(sum, log_odds.min(), log_odds.max()));
}

}  // namespace

CellByte fuse(Fusion fusion, const LogOdds& log_odds, const CellStack& stack, CellByte latest) {
  const CellByte highest = most_occupied(stack);
  if (highest == kNeverObserved) return kNeverObserved;
  switch (fusion) {
    case Fusion::max:
      return highest;
    case Fusion::sum:
      return sum(log_odds, stack);
    case Fusion::latest:
      break;
  }
  return latest == 0 ? highest : stack[static_cast<std::size_t>(latest - 1)];
}

}  // namespace portolan
