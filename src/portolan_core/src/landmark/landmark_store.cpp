// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/landmark/landmark_store.hpp"

#include <algorithm>
#include <cmath>

namespace portolan {

namespace {

constexpr double kFurthestCell = 1e9;  // both coordinates of a cell fit into one number

std::int64_t cell_coordinate(double p, double side) {
  return static_cast<std::int64_t>(std::floor(std::clamp(p / side, -kFurthestCell, kFurthestCell)));
}

LandmarkStore::Square square_of(const Eigen::Vector3d& p_map, double side) {
  return {cell_coordinate(p_map.x(), side), cell_coordinate(p_map.y(), side)};
}

std::int64_t key_of(const LandmarkStore::Square& square) {
  return square.x * (std::int64_t{1} << 32) + square.y;
}

Eigen::Vector3d standing_place(const Place& place) {
  return place.form == PlaceForm::point ? place.mean
                                        : Eigen::Vector3d(place.T_map_ray.translation());
}

std::int64_t cell_of(const Place& place, double side) {
  return key_of(square_of(standing_place(place), side));
}

}  // namespace

std::vector<LandmarkId> LandmarkStore::ids() const {
  std::vector<LandmarkId> all;
  all.reserve(entries_.size());
  for (const auto& [id, entry] : entries_) all.push_back(id);
  std::sort(all.begin(), all.end());
  return all;
}

void LandmarkStore::add(LandmarkId id, const LandmarkTrack& track, bool loaded) {
  const std::int64_t cell = cell_of(track.place(), kCell);
  cells_[cell].push_back(id);
  entries_.insert_or_assign(id, Entry{track, loaded, {}, {}, cell});
}

void LandmarkStore::remove(LandmarkId id) {
  const auto found = entries_.find(id);
  const auto cell = cells_.find(found->second.cell);
  std::vector<LandmarkId>& in_cell = cell->second;
  in_cell.erase(std::find(in_cell.begin(), in_cell.end(), id));
  if (in_cell.empty()) cells_.erase(cell);
  entries_.erase(found);
}

void LandmarkStore::moved(LandmarkId id) {
  Entry& entry = entries_.at(id);
  const std::int64_t cell = cell_of(entry.track.place(), kCell);
  if (cell == entry.cell) return;
  const auto before = cells_.find(entry.cell);
  std::vector<LandmarkId>& in_cell = before->second;
  in_cell.erase(std::find(in_cell.begin(), in_cell.end(), id));
  if (in_cell.empty()) cells_.erase(before);
  cells_[cell].push_back(id);
  entry.cell = cell;
}

void LandmarkStore::append_near(const Eigen::Vector3d& p_map, double radius,
                                std::vector<LandmarkId>& ids) const {
  const Square from = square_of(p_map.array() - radius, kCell);
  const Square to = square_of(p_map.array() + radius, kCell);
  const double squares =
      static_cast<double>(to.x - from.x + 1) * static_cast<double>(to.y - from.y + 1);
  if (squares > static_cast<double>(entries_.size())) return append_within(from, to, ids);
  for (std::int64_t x = from.x; x <= to.x; ++x) {
    for (std::int64_t y = from.y; y <= to.y; ++y) {
      const auto cell = cells_.find(key_of({x, y}));
      if (cell != cells_.end()) ids.insert(ids.end(), cell->second.begin(), cell->second.end());
    }
  }
}

// The same, for a wide part of a small map.
void LandmarkStore::append_within(const Square& from, const Square& to,
                                  std::vector<LandmarkId>& ids) const {
  const std::size_t before = ids.size();
  for (const auto& [id, entry] : entries_) {
    const Square s = square_of(standing_place(entry.track.place()), kCell);
    if (from.x <= s.x && s.x <= to.x && from.y <= s.y && s.y <= to.y) ids.push_back(id);
  }
  std::sort(ids.begin() + static_cast<std::ptrdiff_t>(before), ids.end());
}

}  // namespace portolan
