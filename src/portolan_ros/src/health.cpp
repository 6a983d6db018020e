// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/health.hpp"

#include <numeric>
#include <utility>

namespace portolan {

namespace {

std::string words(Drop reason) {
  switch (reason) {
    case Drop::malformed:
      return "malformed";
    case Drop::no_stamp:
      return "without a stamp";
    case Drop::repeated_stamp:
      return "with a stamp that the sensor had sent before";
    case Drop::no_transform:
      return "without a transform";
    case Drop::queue_full:
      return "crowded out while they waited for tf";
    case Drop::time_ran_back:
      return "waiting for tf when time ran back";
    case Drop::thinned:
      return "thinned";
    case Drop::rejected:
      return "rejected from their pose";
    case Drop::unusable:
      return "unusable";
  }
  return "";
}

}  // namespace

void Tally::drop(Drop reason, std::string detail) {
  ++dropped_[static_cast<std::size_t>(reason)];
  if (!detail.empty()) details_[static_cast<std::size_t>(reason)] = std::move(detail);
}

std::uint64_t Tally::lost() const {
  return std::accumulate(dropped_.begin(), dropped_.end(), std::uint64_t{0}) -
         dropped(Drop::thinned);
}

std::uint64_t Tally::waiting() const { return received_ - used_ - lost() - dropped(Drop::thinned); }

std::string Tally::sentence() const {
  if (received_ == 0) return "no " + noun_ + " received";
  std::string text =
      std::to_string(used_) + " of " + std::to_string(received_) + " " + noun_ + " used";
  std::string separator = ": ";
  for (std::size_t i = 0; i < dropped_.size(); ++i) {
    if (dropped_[i] == 0) continue;
    // One reason for all: what still waits will hardly fare better.
    if (dropped_[i] + waiting() == received_ && !details_[i].empty()) {
      return text + ": " + details_[i];
    }
    text += separator + std::to_string(dropped_[i]) + " " + words(static_cast<Drop>(i));
    if (!details_[i].empty()) text += " (" + details_[i] + ")";
    separator = ", ";
  }
  if (waiting() > 0)
    text += separator + std::to_string(waiting()) + " waiting for tf or their turn";
  return text;
}

}  // namespace portolan
