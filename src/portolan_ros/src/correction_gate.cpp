// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/correction_gate.hpp"

#include <utility>

namespace portolan {

std::optional<Correction> CorrectionGate::take(Correction correction, Time stamp, Time now) {
  const bool sender_ran_back = sender_clock_.ran_back(stamp);
  const bool is_known = std::exchange(clock_ran_back_, false);
  if (!early_ && (!sender_ran_back || is_known)) return correction;
  if (!early_) since_ = now;
  early_ = std::move(correction);
  return std::nullopt;
}

std::optional<Correction> CorrectionGate::overdue(Time now) {
  constexpr Duration kLead = seconds(1.0);
  return early_ && now > since_ + kLead ? let_pass() : std::nullopt;
}

std::optional<Correction> CorrectionGate::clock_ran_back() {
  clock_ran_back_ = !early_;
  return let_pass();
}

std::optional<Correction> CorrectionGate::let_pass() { return std::exchange(early_, std::nullopt); }

}  // namespace portolan
