// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/log_odds.hpp"

#include <algorithm>
#include <cmath>

namespace portolan {

namespace {

constexpr int kZero = 128;  // the byte of log-odds 0

double logit(double p) { return std::log(p / (1.0 - p)); }

int quanta(double log_odds, double quantum) {
  return static_cast<int>(std::lround(std::clamp(log_odds / quantum, -127.0, 127.0)));
}

CellByte to_byte(int quanta) { return static_cast<CellByte>(kZero + quanta); }

}  // namespace

LogOdds::LogOdds(const GridOptions& options)
    : quantum_(options.quantum),
      // Towards zero, so that the limits themselves are kept.
      min_(to_byte(static_cast<int>(logit(options.p_min) / quantum_))),
      max_(to_byte(static_cast<int>(logit(options.p_max) / quantum_))),
      prior_(std::clamp(to_byte(quanta(logit(options.prior), quantum_)), min_, max_)) {
  for (int cell = 0; cell < 256; ++cell) {
    const double log_odds = quantum_ * (cell - kZero);
    probability_[static_cast<std::size_t>(cell)] = 1.0 - 1.0 / (1.0 + std::exp(log_odds));  // Eq. 8
  }
}

CellUpdate LogOdds::update(const InverseSensorModel& model) const {
  const double prior = logit(probability(prior_));
  const int occupied = std::max(1, quanta(logit(model.p_occupied) - prior, quantum_));
  const int free = std::max(1, quanta(prior - logit(model.p_free), quantum_));
  const int span = max_ - min_;
  CellUpdate update;
  update.prior = prior_;
  update.free_step = static_cast<CellByte>(std::min(free, span));
  update.free_floor = static_cast<CellByte>(min_ + update.free_step);
  update.occupied_step = static_cast<CellByte>(std::min(occupied, span));
  update.occupied_ceiling = static_cast<CellByte>(max_ - update.occupied_step);
  return update;
}

CellByte LogOdds::byte(double probability) const {
  if (probability <= 0.0) return min_;
  if (probability >= 1.0) return max_;
  return std::clamp(to_byte(quanta(logit(probability), quantum_)), min_, max_);
}

}  // namespace portolan
