// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/landmark/landmark_mapper.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "portolan/landmark/chi_squared.hpp"

namespace portolan {

namespace {

std::array<double, 4> gates(double probability) {
  return {0.0, chi_squared_quantile(probability, 1), chi_squared_quantile(probability, 2),
          chi_squared_quantile(probability, 3)};
}

bool is_identity(LandmarkId id) { return id >= 0; }

SensorKind kind_of(const LandmarkMapper::Observation& z) {
  return std::holds_alternative<ImageFeatures>(z) ? SensorKind::image : SensorKind::sightings;
}

}  // namespace

LandmarkMapper::LandmarkMapper(const Options& options)
    : options_(checked(options)),
      gates_(gates(options.wrong.gate)),
      merge_gates_(gates(options.identity.merge_gate)) {}

Outcome LandmarkMapper::insert(const Observation& z, const Pose& T_map_sensor) {
  Message message;
  message.kind = kind_of(z);
  message.sensor = std::visit(
      [&](const auto& seen) {
        return uncertain(T_map_sensor, seen.pose_covariance, options_.pose);
      },
      z);
  message.sighted = std::visit([this](const auto& seen) { return well_formed(seen); }, z);
  if (!std::visit([](const auto& seen) { return is_usable(seen); }, z)) return Outcome::unusable;
  ++messages_;
  identify(message);
  std::vector<LandmarkId> seen;
  bool used_any = message.sighted.empty();
  for (std::size_t i = 0; i < message.sighted.size(); ++i) used_any |= use(i, message, seen);
  note_seen(seen, message);
  for (const LandmarkId id : seen) merge_double(id);
  note_missed(message);
  return used_any ? Outcome::inserted : Outcome::rejected;
}

LandmarkId LandmarkMapper::identity(LandmarkId stated) const {
  constexpr LandmarkId kNone = -1;
  return options_.identity.stated == StatedIdentities::used ? stated : kNone;
}

std::vector<LandmarkMapper::Sighted> LandmarkMapper::well_formed(const LandmarkSightings& z) {
  std::vector<Sighted> sighted;
  sighted.reserve(z.sightings.size());
  for (const LandmarkSighting& sighting : z.sightings) {
    if (is_usable(sighting)) {
      sighted.push_back({identity(sighting.id), measurement_of(sighting, options_.noise)});
    } else {
      ++counts_.malformed;
    }
  }
  return sighted;
}

std::vector<LandmarkMapper::Sighted> LandmarkMapper::well_formed(const ImageFeatures& z) {
  std::vector<Sighted> sighted;
  sighted.reserve(z.features.size());
  for (const ImageFeature& feature : z.features) {
    if (is_usable(feature) && is_usable(z.camera)) {
      sighted.push_back({identity(feature.id), measurement_of(feature, z.camera, options_.noise)});
    } else {
      ++counts_.malformed;
    }
  }
  return sighted;
}

void LandmarkMapper::identify(Message& message) const {
  message.doubtful.resize(message.sighted.size(), false);
  for (std::size_t i = 0; i < message.sighted.size(); ++i) {
    if (is_identity(message.sighted[i].id)) {
      add_identified(i, message);
    } else {
      add_similar(i, message);
    }
  }
  choose(message);
}

void LandmarkMapper::add_identified(std::size_t i, Message& message) const {
  const auto& [id, z] = message.sighted[i];
  if (!store_.has(id)) return;
  constexpr Fit kNone{std::numeric_limits<double>::infinity(), 0.0, 1};
  const Fit fits = fit(store_.at(id).track.place(), z, message.sensor).value_or(kNone);
  message.identified.push_back({i, id, fits, {}});
}

void LandmarkMapper::add_similar(std::size_t i, Message& message) const {
  const Measurement& z = message.sighted[i].z;
  const Pose& T_map_sensor = message.sensor.T_map_sensor;
  std::vector<LandmarkId> near;
  if (const auto p_map = shown_point(z, T_map_sensor)) {
    const Place place = first_place(z, message.sensor, options_);
    const double stddev = std::sqrt(place.covariance.topLeftCorner<2, 2>().trace());
    store_.append_near(*p_map, 2.0 * std::sqrt(gates_[2]) * stddev, near);
  } else {
    store_.append_near(T_map_sensor.translation(), options_.identity.reach, near);
  }
  const double doubt = options_.identity.birth_gate * options_.identity.birth_gate;
  for (const LandmarkId id : near) {
    const Place& place = store_.at(id).track.place();
    const std::optional<Fit> fits = fit(place, z, message.sensor);
    if (!fits) continue;
    if (fits->distance < gates_[static_cast<std::size_t>(fits->size)]) {
      message.similar.push_back({i, id, *fits, {}});
      if (options_.identity.matching == LandmarkMatching::joint)
        message.similar.back().term = joint_term(place, z, T_map_sensor);
    } else if (fits->distance < doubt) {
      message.doubtful[i] = true;
    }
  }
}

void LandmarkMapper::choose(Message& message) const {
  message.matches = match_nearest(message.identified, message.sighted.size());
  const auto is_taken = [&](const Candidate& similar) {
    return std::any_of(message.identified.begin(), message.identified.end(),
                       [&](const Candidate& c) { return c.landmark == similar.landmark; });
  };
  std::vector<Candidate>& similar = message.similar;
  similar.erase(std::remove_if(similar.begin(), similar.end(), is_taken), similar.end());
  if (similar.empty()) return;
  const Matches others = options_.identity.matching == LandmarkMatching::nearest
                             ? match_nearest(similar, message.sighted.size())
                             : match_jointly(similar, message.sighted.size(),
                                             message.sensor.covariance, options_.wrong.gate);
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (others[i] != nullptr) message.matches[i] = others[i];
  }
}

bool LandmarkMapper::use(std::size_t i, const Message& message, std::vector<LandmarkId>& seen) {
  const Sighted& sighted = message.sighted[i];
  if (const Candidate* candidate = message.matches[i]) {
    seen.push_back(candidate->landmark);
    return take(sighted, *candidate, message.sensor);
  }
  if (is_identity(sighted.id) && store_.has(sighted.id)) return ++counts_.repeated, false;
  if (message.doubtful[i]) return ++counts_.wrong, false;
  return start(sighted, message.sensor, seen);
}

bool LandmarkMapper::take(const Sighted& sighted, const Candidate& candidate,
                          const UncertainSensorPose& sensor) {
  LandmarkStore::Entry& entry = store_.at(candidate.landmark);
  const double gate = gates_[static_cast<std::size_t>(candidate.fit.size)];
  const bool fits = candidate.fit.distance < gate;
  ++(fits ? counts_.taken : counts_.wrong);
  if (is_fixed(entry)) return fits;
  if (fits) {
    entry.track.take(sighted.z, sensor, candidate.fit, options_);
  } else if (entry.track.contradict(sighted.z, sensor, gate, options_)) {
    ++counts_.moved;
  }
  store_.moved(candidate.landmark);
  ++revision_;
  return true;
}

bool LandmarkMapper::start(const Sighted& sighted, const UncertainSensorPose& sensor,
                           std::vector<LandmarkId>& seen) {
  if (store_.size() == options_.max_landmarks) return ++counts_.refused, false;
  const LandmarkId id = is_identity(sighted.id) ? sighted.id : next_id_--;
  store_.add(id, LandmarkTrack(sighted.z, sensor, options_), false);
  seen.push_back(id);
  ++counts_.taken;
  ++revision_;
  return true;
}

bool LandmarkMapper::is_fixed(const LandmarkStore::Entry& entry) const {
  return entry.loaded && options_.loaded == LoadedLandmarks::fixed;
}

bool LandmarkMapper::is_believed(LandmarkId id, const LandmarkStore::Entry& entry) const {
  const std::size_t enough =
      is_identity(id) ? options_.existence.identified_sightings : options_.existence.sightings;
  const bool may_be_spurious = !is_identity(id) && entry.track.log_odds() < 0.0;
  return entry.loaded || (entry.track.sightings() >= enough && !may_be_spurious);
}

std::vector<LandmarkEstimate> LandmarkMapper::estimates() const {
  std::vector<LandmarkEstimate> all;
  for (const LandmarkId id : store_.ids()) {
    const LandmarkStore::Entry& entry = store_.at(id);
    if (is_believed(id, entry)) all.push_back(estimate(id, entry.track));
  }
  return all;
}

LandmarkEstimate LandmarkMapper::estimate(LandmarkId id, const LandmarkTrack& track) const {
  const double max_depth = options_.unmeasured.max_depth;
  const Place point = as_point(track.place(), max_depth);
  LandmarkEstimate estimate;
  estimate.id = id;
  if (track.place().form == PlaceForm::ray)
    estimate.form =
        has_depth(track.place(), max_depth) ? LandmarkForm::ray : LandmarkForm::direction;
  estimate.mean = point.mean;
  // An offset that is never estimated (Schmidt's consider filter): the landmark's and the
  // detector's. It is in each sighting alike, so that nothing of it enters the innovations.
  const double repeated = options_.noise.repeated_stddev * options_.noise.repeated_stddev;
  estimate.covariance = point.covariance + repeated * Eigen::Matrix3d::Identity();
  const bool is_flat = options_.space == LandmarkSpace::planar ||
                       (options_.space == LandmarkSpace::automatic && !track.has_height());
  if (is_flat) {
    estimate.mean.z() = 0.0;
    estimate.covariance.row(2).setZero();
    estimate.covariance.col(2).setZero();
  }
  estimate.sightings = track.sightings();
  estimate.existence = track.existence();
  estimate.place = track.place();
  return estimate;
}

LandmarkMapper LandmarkMapper::restored(
    const Options& options, const std::vector<std::pair<LandmarkId, LandmarkTrack>>& tracks) {
  LandmarkMapper mapper(options);
  for (const auto& [id, track] : tracks) {
    mapper.store_.add(id, track, true);
    mapper.next_id_ = std::min(mapper.next_id_, id - 1);
    mapper.counts_.taken += track.sightings();
  }
  return mapper;
}

}  // namespace portolan
