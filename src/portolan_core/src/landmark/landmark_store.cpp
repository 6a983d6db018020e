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

std::int64_t cell_key(std::int64_t x, std::int64_t y) { return x * (std::int64_t{1} << 32) + y; }

Eigen::Vector3d standing_place(const Place& place) {
  return place.form == PlaceForm::point ? place.mean
                                        : Eigen::Vector3d(place.T_map_ray.translation());
}

std::int64_t cell_of(const Place& place, double side) {
  const Eigen::Vector3d p = standing_place(place);
  return cell_key(cell_coordinate(p.x(), side), cell_coordinate(p.y(), side));
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
  const std::int64_t left = cell_coordinate(p_map.x() - radius, kCell);
  const std::int64_t right = cell_coordinate(p_map.x() + radius, kCell);
  const std::int64_t bottom = cell_coordinate(p_map.y() - radius, kCell);
  const std::int64_t top = cell_coordinate(p_map.y() + radius, kCell);
  for (std::int64_t x = left; x <= right; ++x) {
    for (std::int64_t y = bottom; y <= top; ++y) {
      const auto cell = cells_.find(cell_key(x, y));
      if (cell != cells_.end()) ids.insert(ids.end(), cell->second.begin(), cell->second.end());
    }
  }
}

}  // namespace portolan
