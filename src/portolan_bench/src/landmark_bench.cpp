// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "pairs.hpp"
#include "plain_landmarks.hpp"
#include "portolan/landmark/landmark_mapper.hpp"

namespace portolan::bench {
namespace {

constexpr double kReach = 6.0;  // of the sensor [m]
constexpr double kRangeStddev = 0.05;
constexpr double kAzimuthStddev = 0.01;

/// What a sensor sees from here and there in a wood with one tree on every 4 square metres.
struct Wood {
  struct Posed {
    Pose T_map_sensor;
    LandmarkSightings z;
  };

  explicit Wood(std::size_t count) : random_(1) {
    side_ = 2.0 * std::sqrt(static_cast<double>(count));
    trees_.reserve(count);
    const auto columns = static_cast<std::size_t>(std::ceil(0.5 * side_));
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t column = i % columns;
      const std::size_t row = i / columns;
      const double x = 2.0 * static_cast<double>(column) + uniform(-0.4, 0.4);
      const double y = 2.0 * static_cast<double>(row) + uniform(-0.4, 0.4);
      trees_.emplace_back(x, y, 0.0);
    }
  }

  /// Each tree once, from two metres away.
  std::vector<Posed> first_round() {
    std::vector<Posed> round;
    for (std::size_t i = 0; i < trees_.size(); ++i) {
      Posed posed{planar_pose(trees_[i].x() - 2.0, trees_[i].y(), 0.0), {}};
      see(i, posed);
      round.push_back(posed);
    }
    return round;
  }

  /// All in reach, from random places.
  std::vector<Posed> visits(std::size_t count) {
    std::vector<Posed> visits;
    for (std::size_t visit = 0; visit < count; ++visit) {
      Posed posed{planar_pose(uniform(0.0, side_), uniform(0.0, side_), uniform(-3.0, 3.0)), {}};
      for (std::size_t i = 0; i < trees_.size(); ++i) {
        const Eigen::Vector3d step = trees_[i] - posed.T_map_sensor.translation();
        if (step.norm() < kReach) see(i, posed);
      }
      visits.push_back(posed);
    }
    return visits;
  }

  /// How far the trees of these numbers are from where they are mapped, root mean square [m].
  template <class Places>
  double rms_error(const Places& places) const {
    double sum = 0.0;
    std::size_t count = 0;
    for (const auto& [tree, mean] : places) {
      if (tree < 0 || static_cast<std::size_t>(tree) >= trees_.size()) continue;
      const Eigen::Vector3d& truth = trees_[static_cast<std::size_t>(tree)];
      sum += (mean - truth.head<2>()).squaredNorm();
      ++count;
    }
    return std::sqrt(sum / static_cast<double>(count));
  }

  bool with_identities = true;

 private:
  void see(std::size_t tree, Posed& posed) {
    const Eigen::Vector3d l = posed.T_map_sensor.inverse() * trees_[tree];
    LandmarkSighting sighting;
    if (with_identities) sighting.id = static_cast<std::int32_t>(tree);
    sighting.range = l.norm() + normal(kRangeStddev);
    sighting.azimuth = std::atan2(l.y(), l.x()) + normal(kAzimuthStddev);
    sighting.range_stddev = kRangeStddev;
    sighting.azimuth_stddev = kAzimuthStddev;
    posed.z.sightings.push_back(sighting);
  }
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  double normal(double stddev) { return std::normal_distribution<double>(0.0, stddev)(random_); }

  std::mt19937_64 random_;
  std::vector<Eigen::Vector3d> trees_;
  double side_;
};

template <class Map>
void insert_all(const std::vector<Wood::Posed>& posed, Map& map) {
  for (const Wood::Posed& one : posed) map.insert(one.z, one.T_map_sensor);
}

std::size_t sightings_in(const std::vector<Wood::Posed>& visits) {
  std::size_t count = 0;
  for (const Wood::Posed& visit : visits) count += visit.z.sightings.size();
  return count;
}

using Places = std::vector<std::pair<std::int32_t, Eigen::Vector2d>>;

Places places_of(const LandmarkMapper& map) {
  Places places;
  for (const LandmarkEstimate& landmark : map.estimates())
    places.emplace_back(landmark.id, landmark.mean.head<2>());
  return places;
}

Places places_of(const PlainLandmarks& map) {
  Places places;
  for (const auto& [id, landmark] : map.landmarks()) places.emplace_back(id, landmark.mean);
  return places;
}

/// Microseconds for a sighting in a map that holds so many landmarks already.
void map_landmarks(benchmark::State& state, bool with_identities) {
  const auto count = static_cast<std::size_t>(state.range(0));
  Wood wood(count);
  wood.with_identities = true;
  const std::vector<Wood::Posed> first = wood.first_round();
  wood.with_identities = with_identities;
  // The plain one looks at every landmark: few visits are enough to tell.
  const std::vector<Wood::Posed> visits =
      wood.visits(with_identities ? 1000 : std::max<std::size_t>(4, 20000 / count));
  LandmarkMapper ours{LandmarkOptions{}};
  PlainLandmarks plain;
  insert_all(first, ours);
  insert_all(first, plain);
  Pairs pairs;
  for (auto _ : state) {
    state.SetIterationTime(
        pairs.run([&] { insert_all(visits, plain); }, [&] { insert_all(visits, ours); }));
  }
  const auto sightings = static_cast<double>(sightings_in(visits));
  state.counters["us_ours"] = 1e6 * pairs.ours() / sightings;
  state.counters["us_plain"] = 1e6 * pairs.peer() / sightings;
  state.counters["times_plain"] = pairs.ratio();
  state.counters["mm_ours"] = 1e3 * wood.rms_error(places_of(ours));
  state.counters["mm_plain"] = 1e3 * wood.rms_error(places_of(plain));
  state.counters["landmarks"] = static_cast<double>(ours.store().size());
}

void map_identified(benchmark::State& state) { map_landmarks(state, true); }
void map_unidentified(benchmark::State& state) { map_landmarks(state, false); }

BENCHMARK(map_identified)->Arg(10)->Arg(1000)->Arg(100000)->UseManualTime()->Iterations(5);
BENCHMARK(map_unidentified)->Arg(10)->Arg(1000)->Arg(100000)->UseManualTime()->Iterations(5);

}  // namespace
}  // namespace portolan::bench
