// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "portolan/landmark/landmark_track.hpp"

namespace portolan {

/// The landmarks of a map, found by identity or by place at a cost that does not grow with the map.
///
/// A ray stands where it was first seen from, since where it ends is not known.
class LandmarkStore {
 public:
  struct Entry {
    LandmarkTrack track;
    bool loaded = false;                       ///< from a file
    std::array<std::uint64_t, 2> last_seen{};  ///< in which message, by SensorKind
    std::vector<LandmarkId> beside;            ///< others near by, seen in the same message
    std::int64_t cell = 0;
  };

  /// A square of the grid that finds landmarks by where they stand.
  struct Square {
    std::int64_t x;
    std::int64_t y;
  };

  std::size_t size() const { return entries_.size(); }
  bool has(LandmarkId id) const { return entries_.count(id) > 0; }
  Entry& at(LandmarkId id) { return entries_.at(id); }
  const Entry& at(LandmarkId id) const { return entries_.at(id); }

  /// Calls `visit(id, entry)` with each, in no order that may matter.
  template <class Visit>
  void for_each(Visit visit) const {
    for (const auto& [id, entry] : entries_) visit(id, entry);
  }

  /// All identities, smallest first.
  std::vector<LandmarkId> ids() const;

  void add(LandmarkId id, const LandmarkTrack& track, bool loaded);
  void remove(LandmarkId id);

  /// Must be called after the landmark's place changed.
  void moved(LandmarkId id);

  /// Appends those whose square of the grid touches the square of side 2 `radius` [m] about
  /// `p_map`: all that stand nearer, and a few more. The order depends on the map alone.
  void append_near(const Eigen::Vector3d& p_map, double radius, std::vector<LandmarkId>& ids) const;

 private:
  void append_within(const Square& from, const Square& to, std::vector<LandmarkId>& ids) const;

  static constexpr double kCell = 2.0;  // [m]

  std::unordered_map<LandmarkId, Entry> entries_;
  std::unordered_map<std::int64_t, std::vector<LandmarkId>> cells_;
};

}  // namespace portolan
