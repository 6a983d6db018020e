// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "portolan/remapper.hpp"
#include "random_pose.hpp"

namespace portolan {
/// An observation of which the map only lists the number; negative ones are unusable.
struct Sight {
  int id = 0;
};

inline std::size_t byte_size(const Sight& /*z*/) { return 1000; }

/// A map in which order and every bit of a pose show: the list of what was inserted, and where.
class ListMapper {
 public:
  struct Options {
    double reach = 1e9;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor& visit) {
      visit("reach", self.reach, "x beyond which it rejects [m]", above(0.0));
    }
  };
  using Observation = Sight;

  explicit ListMapper(const Options& options) : options_(checked(options)) {}

  Outcome insert(const Sight& z, const Pose& T_map_sensor) {
    if (z.id < 0) return Outcome::unusable;
    if (T_map_sensor.translation().x() > options_.reach) return Outcome::rejected;
    ids_.push_back(z.id);
    poses_.push_back(T_map_sensor);
    return Outcome::inserted;
  }

  const std::vector<int>& ids() const { return ids_; }
  const std::vector<Pose>& poses() const { return poses_; }

 private:
  Options options_;
  std::vector<int> ids_;
  std::vector<Pose> poses_;
};

using ListRemapper = Remapper<ListMapper>;
using Ids = std::vector<int>;

inline void expect_equal(const ListMapper& a, const ListMapper& b) {
  ASSERT_EQ(a.ids(), b.ids());
  for (std::size_t i = 0; i < a.poses().size(); ++i) {
    EXPECT_EQ(a.poses()[i].matrix(), b.poses()[i].matrix()) << "observation " << i;
  }
}

inline Time at_second(double s) { return Time(seconds(s)); }

inline ListRemapper unlimited() { return ListRemapper(RemapperOptions{}, ListMapper::Options{}); }

/// Room for so many observations.
inline ListRemapper with_room_for(int count) {
  ListRemapper probe = unlimited();
  probe.observe(Time(), Pose::Identity(), Sight{});
  RemapperOptions options;
  options.log_budget = static_cast<double>(probe.log_bytes()) * (count + 0.5) * 1e-6;
  return ListRemapper(options, ListMapper::Options{});
}

/// A drive: one observation a second from a random pose.
struct Drive {
  explicit Drive(std::uint64_t seed, int count = 40) {
    std::mt19937_64 random(seed);
    for (int i = 0; i < count; ++i) poses.push_back(random_pose(random));
  }
  void observe(ListRemapper& remapper, int from, int to) const {
    for (int i = from; i < to; ++i) {
      remapper.observe(at_second(i), poses[static_cast<std::size_t>(i)], Sight{i});
    }
  }
  void observe_all(ListRemapper& remapper) const {
    observe(remapper, 0, static_cast<int>(poses.size()));
  }
  std::vector<Pose> poses;
};

inline Correction random_correction(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Correction::Knot> knots;
  knots.reserve(5);
  for (int i = 0; i < 5; ++i) knots.push_back({at_second(9.5 * i), random_pose(random)});
  return Correction(knots);
}

/// Moves only what is seen after `from` [s].
inline Correction correction_from(double from, double x) {
  return Correction(
      {{at_second(from), Pose::Identity()}, {at_second(from + 1.0), planar_pose(x, 0.0, 0.0)}});
}

inline ListMapper told_early(const Drive& drive, const Correction& correction) {
  ListRemapper remapper = unlimited();
  remapper.correct(correction);
  drive.observe_all(remapper);
  return remapper.map();
}

/// To draw one observation and no more.
inline constexpr auto kNoTime = [] { return false; };

}  // namespace portolan
