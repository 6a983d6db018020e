// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <optional>
#include <utility>

#include "portolan/correction.hpp"
#include "portolan/options.hpp"
#include "portolan/outcome.hpp"
#include "portolan/thinning.hpp"

namespace portolan {

/// What a `Remapper` may keep, and what it lets in.
struct RemapperOptions {
  double log_budget = 512.0;
  Thinning::Options thinning;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("log_budget", self.log_budget,
          "memory for observations that corrections can still move [MB]", above(0.0));
    visit("thinning", self.thinning, "which observations enter");
  }
};

/// Draws a map and draws it anew when the trajectory is corrected.
///
/// It keeps every observation with its odometry pose. The map is always
///   fold(insert, base, [(z_i, T_map_odom(t_i) * T_odom_sensor_i)]),
/// so one that is told of a correction late equals one that knew it from the start, bit for bit.
/// Past the budget the oldest observations are folded into the base, which no longer moves.
template <class Mapper>
class Remapper {
 public:
  using Observation = typename Mapper::Observation;

  /// Throws OptionsError.
  Remapper(const RemapperOptions& options, const typename Mapper::Options& mapper_options)
      : options_(checked(options)), mapper_options_(mapper_options), map_(mapper_options_) {}

  /// Takes an observation that the sensor made at `stamp` from `T_odom_sensor`. The outcome that
  /// the mapper gave; none where thinning turned it away. What is unusable is not kept; what was
  /// rejected is, since another correction may bring it to a better pose.
  std::optional<Outcome> observe(Time stamp, const Pose& T_odom_sensor, Observation z,
                                 SensorId sensor = 0);

  /// Takes a new correction. The map is drawn anew by `replay`, unless no observation moves.
  void correct(Correction correction);

  /// Draws on while the predicate holds; true when the map is up to date. At least one
  /// observation is drawn in each call, so that any predicate comes to an end.
  template <class Predicate>
  bool replay(Predicate while_time_is_left);

  /// Draws until the map is up to date.
  void finish() {
    replay([] { return true; });
  }

  bool is_up_to_date() const { return !redraw_; }

  /// The share of the redrawing that is done, in [0, 1]; 1 when up to date.
  double progress() const;

  /// The map: while it is redrawn, the one before, with what has come since at its new pose.
  const Mapper& map() const { return map_; }

  /// Counts the times that another map took the place of the one before: redrawn, reset, loaded.
  std::size_t generation() const { return generation_; }

  const Correction& correction() const { return correction_; }

  /// Starts from this map instead of an empty one; what was observed before is forgotten, the
  /// correction is not.
  void restart_from(Mapper map);

  /// Starts from an empty map; the correction is forgotten too.
  void reset();

  /// Folds the whole log into the base: what the map shows now can no longer move.
  void freeze();

  /// What the log occupies [byte], how many observations it holds, and how many were folded into
  /// the base because the budget was used up.
  std::size_t log_bytes() const { return log_bytes_; }
  std::size_t log_size() const { return log_.size(); }
  std::size_t frozen() const { return frozen_; }

 private:
  struct Entry {
    Time stamp;
    Pose T_odom_sensor;
    Observation z;
  };
  struct Redraw {
    Mapper map;
    std::size_t next = 0;  // into the log
  };

  Pose in_map(const Entry& entry) const {
    return correction_.at(entry.stamp) * entry.T_odom_sensor;
  }
  Mapper base() const { return base_ ? *base_ : Mapper(mapper_options_); }
  static std::size_t size_of(const Entry& entry) {
    return sizeof(Entry) - sizeof(Observation) + byte_size(entry.z);
  }
  void freeze_oldest();

  RemapperOptions options_;
  typename Mapper::Options mapper_options_;
  Thinning thinning_{options_.thinning};
  Correction correction_;
  std::optional<Mapper> base_;
  std::deque<Entry> log_;
  std::size_t log_bytes_ = 0;
  std::size_t frozen_ = 0;
  std::size_t generation_ = 0;
  Mapper map_;
  std::optional<Redraw> redraw_;
};

template <class Mapper>
std::optional<Outcome> Remapper<Mapper>::observe(Time stamp, const Pose& T_odom_sensor,
                                                 Observation z, SensorId sensor) {
  if (!is_valid(T_odom_sensor)) return Outcome::rejected;
  if (!thinning_.admits(stamp, T_odom_sensor, sensor)) return std::nullopt;
  Entry entry{stamp, T_odom_sensor, std::move(z)};
  const Outcome outcome = map_.insert(entry.z, in_map(entry));
  if (outcome == Outcome::unusable) return outcome;
  thinning_.remember(stamp, T_odom_sensor, sensor);
  log_bytes_ += size_of(entry);
  log_.push_back(std::move(entry));
  while (static_cast<double>(log_bytes_) > options_.log_budget * 1e6) freeze_oldest();
  return outcome;
}

template <class Mapper>
void Remapper<Mapper>::correct(Correction correction) {
  const bool was_up_to_date = is_up_to_date();
  const auto moves = [&](const Entry& entry) {
    return correction.at(entry.stamp).matrix() != correction_.at(entry.stamp).matrix();
  };
  const bool map_moves = std::any_of(log_.begin(), log_.end(), moves);
  correction_ = std::move(correction);
  if (was_up_to_date && !map_moves) return;
  redraw_.emplace(Redraw{base(), 0});
}

template <class Mapper>
template <class Predicate>
bool Remapper<Mapper>::replay(Predicate while_time_is_left) {
  if (!redraw_) return true;
  do {
    if (redraw_->next == log_.size()) {
      map_ = std::move(redraw_->map);
      ++generation_;
      redraw_.reset();
      return true;
    }
    const Entry& entry = log_[redraw_->next++];
    redraw_->map.insert(entry.z, in_map(entry));
  } while (while_time_is_left());
  return false;
}

template <class Mapper>
double Remapper<Mapper>::progress() const {
  if (!redraw_ || log_.empty()) return 1.0;
  return static_cast<double>(redraw_->next) / static_cast<double>(log_.size());
}

template <class Mapper>
void Remapper<Mapper>::restart_from(Mapper map) {
  Correction correction = std::move(correction_);
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
