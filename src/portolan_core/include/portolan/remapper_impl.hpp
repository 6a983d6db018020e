// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How a Remapper works; remapper.hpp, which includes this, says what it does.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "portolan/remapper.hpp"

namespace portolan {

template <class Mapper>
std::optional<Outcome> Remapper<Mapper>::observe(Time stamp, const Pose& T_odom_sensor,
                                                 Observation z, SensorId sensor) {
  if (!is_valid(T_odom_sensor)) return Outcome::rejected;
  if (!thinning_.admits(stamp, T_odom_sensor, sensor)) return std::nullopt;
  Entry entry{stamp, T_odom_sensor, std::move(z)};
  const Outcome outcome = map_.insert(entry.z, in_map(entry));
  if (outcome == Outcome::unusable) return outcome;
  thinning_.remember(stamp, T_odom_sensor, sensor);
  log_.push_back(std::move(entry));
  log_bytes_ += size_of(log_.back());
  while (static_cast<double>(log_bytes_) > options_.log_budget * 1e6) freeze_oldest();
  return outcome;
}

template <class Mapper>
void Remapper<Mapper>::correct(Correction correction) {
  const auto moves = [&](const Entry& entry) {
    return correction.at(entry.stamp).matrix() != correction_.at(entry.stamp).matrix();
  };
  const auto first = std::find_if(log_.begin(), log_.end(), moves);
  waiting_.reset();
  if (redraw_ && static_cast<std::size_t>(first - log_.begin()) < redraw_->next) {
    waiting_ = std::move(correction);
    return;
  }
  correction_ = std::move(correction);
  if (!redraw_ && first != log_.end()) redraw_.emplace(Redraw{base(), 0});
}

template <class Mapper>
template <class Predicate>
bool Remapper<Mapper>::replay(Predicate while_time_is_left) {
  if (!redraw_) return true;
  do {
    if (redraw_->next < log_.size()) {
      const Entry& entry = log_[redraw_->next++];
      redraw_->map.insert(entry.z, in_map(entry));
    } else {
      show_redrawn();
    }
  } while (redraw_ && while_time_is_left());
  return is_up_to_date();
}

template <class Mapper>
void Remapper<Mapper>::show_redrawn() {
  map_ = std::move(redraw_->map);
  ++generation_;
  redraw_.reset();
  if (waiting_) correct(*waiting_);
}

template <class Mapper>
double Remapper<Mapper>::progress() const {
  if (!redraw_ || log_.empty()) return 1.0;
  return static_cast<double>(redraw_->next) / static_cast<double>(log_.size());
}

template <class Mapper>
void Remapper<Mapper>::restart_from(Mapper map) {
  Correction correction = std::move(waiting_ ? *waiting_ : correction_);
  reset();
  correction_ = std::move(correction);
  map_ = map;
  base_ = std::move(map);
}

template <class Mapper>
void Remapper<Mapper>::reset() {
  const std::size_t generation = generation_ + 1;
  *this = Remapper(options_, mapper_options_);
  generation_ = generation;
}

template <class Mapper>
void Remapper<Mapper>::freeze() {
  finish();
  log_.clear();
  log_bytes_ = 0;
  base_ = map_;
}

template <class Mapper>
void Remapper<Mapper>::freeze_oldest() {
  const Entry& oldest = log_.front();
  if (!base_) base_.emplace(mapper_options_);
  base_->insert(oldest.z, in_map(oldest));
  if (redraw_ && redraw_->next == 0) {
    redraw_->map.insert(oldest.z, in_map(oldest));
    redraw_->next = 1;
  }
  if (redraw_) --redraw_->next;
  log_bytes_ -= size_of(oldest);
  log_.pop_front();
  ++frozen_;
}

}  // namespace portolan
