// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "portolan/landmark/landmark_mapper.hpp"

// What becomes of landmarks when others are seen, or they themselves are not.

namespace portolan {

namespace {

constexpr double kBeside = 3.0;          // [m]: landmarks further apart are not confused
constexpr double kWellKnown = 0.9;       // existence of landmarks that views are learnt from
constexpr double kBelievedMissed = 0.3;  // what hides one that is believed in is likely a wall

/// The point with axes as in REP 103, also for the optical frame of a camera.
Eigen::Vector3d level(const Eigen::Vector3d& l, SensorKind kind) {
  return kind == SensorKind::image ? Eigen::Vector3d(l.z(), -l.x(), -l.y()) : l;
}

void insert_once(LandmarkId id, std::vector<LandmarkId>& ids) {
  if (std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
}

bool contains(const std::vector<LandmarkId>& ids, LandmarkId id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

double squared_distance(const Place& a, const Place& b, int dimensions) {
  const Eigen::Vector3d step = b.mean - a.mean;
  const Eigen::Matrix3d covariance = a.covariance + b.covariance;
  if (dimensions == 3) return step.dot(covariance.ldlt().solve(step));
  const Eigen::Vector2d flat = step.head<2>();
  const Eigen::Matrix2d flat_covariance = covariance.topLeftCorner<2, 2>();
  return flat.dot(flat_covariance.ldlt().solve(flat));
}

}  // namespace

void LandmarkMapper::note_seen(const std::vector<LandmarkId>& seen, const Message& message) {
  const auto kind = static_cast<std::size_t>(message.kind);
  for (const LandmarkId id : seen) {
    LandmarkStore::Entry& entry = store_.at(id);
    entry.last_seen.at(kind) = messages_;
    const Place& place = entry.track.place();
    if (place.form != PlaceForm::point) continue;
    const Eigen::Vector3d step = place.mean - message.sensor.T_map_sensor.translation();
    views_.at(kind).reach_to(std::min(step.norm(), options_.identity.reach));
  }
  const bool all_have_identities = next_id_ == kFirstOwnId;
  if (!all_have_identities) note_beside(seen);
}

/// What is seen side by side is not one.
void LandmarkMapper::note_beside(const std::vector<LandmarkId>& seen) {
  for (std::size_t i = 0; i < seen.size(); ++i) {
    LandmarkStore::Entry& a = store_.at(seen[i]);
    for (std::size_t j = i + 1; j < seen.size(); ++j) {
      LandmarkStore::Entry& b = store_.at(seen[j]);
      if ((a.track.place().mean - b.track.place().mean).head<2>().norm() > kBeside) continue;
      insert_once(seen[j], a.beside);
      insert_once(seen[i], b.beside);
    }
  }
}

void LandmarkMapper::merge_double(LandmarkId id) {
  const bool all_have_identities = next_id_ == kFirstOwnId;
  if (all_have_identities || !store_.has(id)) return;
  const Place& place = store_.at(id).track.place();
  if (place.form != PlaceForm::point) return;
  const double stddev = std::sqrt(place.covariance.topLeftCorner<2, 2>().trace());
  std::vector<LandmarkId> near;
  store_.append_near(place.mean,
                     2.0 * std::sqrt(merge_gates_[2]) * stddev + options_.identity.apart, near);
  for (const LandmarkId other : near) {
    if (!are_one(id, other)) continue;
    // The identity stays, or the place that must not move, or the older one.
    const auto rank = [this](LandmarkId which) {
      return std::make_pair(is_fixed(store_.at(which)), which);
    };
    const LandmarkId kept = std::max(rank(id), rank(other)).second;
    const LandmarkId gone = kept == id ? other : id;
    LandmarkStore::Entry& entry = store_.at(kept);
    const LandmarkStore::Entry& double_entry = store_.at(gone);
    if (!is_fixed(entry)) entry.track.absorb(double_entry.track);
    for (const LandmarkId beside : double_entry.beside) insert_once(beside, entry.beside);
    store_.moved(kept);
    store_.remove(gone);
    ++counts_.merged;
    ++revision_;
    return;
  }
}

bool LandmarkMapper::are_one(LandmarkId a, LandmarkId b) const {
  if (a == b || (a >= 0 && b >= 0)) return false;
  const LandmarkStore::Entry& first = store_.at(a);
  const LandmarkStore::Entry& second = store_.at(b);
  const Place& p = first.track.place();
  const Place& q = second.track.place();
  if (first.loaded && second.loaded) return false;
  if (!is_believed(a, first) || !is_believed(b, second)) return false;
  if (p.form != PlaceForm::point || q.form != PlaceForm::point) return false;
  if (contains(first.beside, b) || contains(second.beside, a)) return false;
  const int dimensions = first.track.has_height() && second.track.has_height() ? 3 : 2;
  if ((p.mean - q.mean).head(dimensions).norm() < options_.identity.apart) return true;
  return squared_distance(p, q, dimensions) < merge_gates_.at(static_cast<std::size_t>(dimensions));
}

/// Landmarks that should have been seen since the view was news the last time, and were not, are
/// a little less likely to exist.
void LandmarkMapper::note_missed(const Message& message) {
  const auto kind = static_cast<std::size_t>(message.kind);
  SensorView& view = views_.at(kind);
  const Pose& T_map_sensor = message.sensor.T_map_sensor;
  if (options_.existence.forget_below == 0.0 || !view.is_news(T_map_sensor)) return;
  std::vector<LandmarkId> near;
  store_.append_near(T_map_sensor.translation(), view.reach(), near);
  const Pose T_sensor_map = T_map_sensor.inverse();
  for (const LandmarkId id : near) {
    LandmarkStore::Entry& entry = store_.at(id);
    if (entry.track.place().form != PlaceForm::point || is_fixed(entry)) continue;
    const Eigen::Vector3d l = level(T_sensor_map * entry.track.place().mean, message.kind);
    const bool is_seen = entry.last_seen.at(kind) > last_news_.at(kind);
    if (!is_seen) {
      const double p_detection = view.p_detection(l);
      entry.track.miss(is_believed(id, entry) ? std::min(p_detection, kBelievedMissed)
                                              : p_detection);
      ++revision_;
    }
    if (entry.track.existence() > kWellKnown) view.note(l, is_seen);
    if (id >= 0 || entry.track.existence() >= options_.existence.forget_below) continue;
    store_.remove(id);
    ++counts_.forgotten;
  }
  last_news_.at(kind) = messages_;
}

}  // namespace portolan
