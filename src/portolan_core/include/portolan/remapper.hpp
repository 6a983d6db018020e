// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <utility>

#include "portolan/correction.hpp"
#include "portolan/outcome.hpp"
#include "portolan/remapper_options.hpp"

namespace portolan {

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
  /// rejected is, since another correction may bring it to a better pose; not so where
  /// T_odom_sensor is no rigid motion, which no correction mends.
  std::optional<Outcome> observe(Time stamp, const Pose& T_odom_sensor, Observation z,
                                 SensorId sensor = 0);

  /// Takes a new correction. The map is drawn anew by `replay`, unless no observation moves. While
  /// it is being redrawn, a correction that moves what is redrawn already waits for the end, and
  /// the last one that came is next: corrections that come fast cannot keep the map from changing.
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

  /// The correction that observations are posed with now.
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
  void show_redrawn();

  RemapperOptions options_;
  typename Mapper::Options mapper_options_;
  Thinning thinning_{options_.thinning};
  Correction correction_;
  std::optional<Correction> waiting_;  // for the redraw to end
  std::optional<Mapper> base_;
  std::deque<Entry> log_;
  std::size_t log_bytes_ = 0;
  std::size_t frozen_ = 0;
  std::size_t generation_ = 0;
  Mapper map_;
  std::optional<Redraw> redraw_;
};

}  // namespace portolan

#include "portolan/remapper_impl.hpp"  // IWYU pragma: export
