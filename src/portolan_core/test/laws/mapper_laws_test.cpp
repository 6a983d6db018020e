// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "laws/beacon_mapper_case.hpp"
#include "laws/grid_mapper_case.hpp"
#include "laws/landmark_mapper_case.hpp"
#include "laws/octo_mapper_case.hpp"
#include "portolan/remapper.hpp"

namespace portolan {
namespace {

// A case says for its mapper: Mapper; options(); observation(); pose(); and equal(a, b), all drawn
// from the seed that it is made with. A mapper joins the laws by its case in this list.
using Cases =
    ::testing::Types<GridMapperCase, BeaconMapperCase, OctoMapperCase, LandmarkMapperCase>;

template <class Case>
class MapperLaws : public ::testing::Test {
 protected:
  using Mapper = typename Case::Mapper;

  struct Entry {
    Time stamp;
    Pose T_odom_sensor;
    typename Mapper::Observation z;
  };

  static constexpr std::uint32_t kSeeds = 20;
  static constexpr int kEntries = 25;

  static std::vector<Entry> log(Case& draw) {
    std::vector<Entry> log;
    log.reserve(kEntries);
    for (int i = 0; i < kEntries; ++i) {
      log.push_back({Time(seconds(0.1 * i)), draw.pose(), draw.observation()});
    }
    return log;
  }

  static Correction correction(Case& draw) {
    std::vector<Correction::Knot> knots;
    knots.reserve(4);
    for (int i = 0; i < 4; ++i) knots.push_back({Time(seconds(0.7 * i)), draw.pose()});
    return Correction(knots);
  }

  static Remapper<Mapper> remapper(const Case& draw, double log_budget = 512.0) {
    RemapperOptions options;
    options.log_budget = log_budget;
    return Remapper<Mapper>(options, draw.options());
  }

  static void observe(Remapper<Mapper>& remapper, const std::vector<Entry>& log) {
    for (const Entry& entry : log) remapper.observe(entry.stamp, entry.T_odom_sensor, entry.z);
  }
};

TYPED_TEST_SUITE(MapperLaws, Cases, );

TYPED_TEST(MapperLaws, LateCorrectionEqualsEarlyCorrection) {
  for (std::uint32_t seed = 0; seed < TestFixture::kSeeds; ++seed) {
    TypeParam draw(seed);
    const auto log = TestFixture::log(draw);
    const Correction correction = TestFixture::correction(draw);
    auto early = TestFixture::remapper(draw);
    early.correct(correction);
    TestFixture::observe(early, log);
    auto late = TestFixture::remapper(draw);
    TestFixture::observe(late, log);
    late.correct(TestFixture::correction(draw));
    late.correct(correction);
    late.finish();
    early.finish();
    EXPECT_TRUE(TypeParam::equal(early.map(), late.map())) << "seed " << seed;
  }
}

TYPED_TEST(MapperLaws, RedrawingInSlicesEqualsRedrawingAtOnce) {
  for (std::uint32_t seed = 0; seed < TestFixture::kSeeds; ++seed) {
    TypeParam draw(seed);
    const auto log = TestFixture::log(draw);
    auto sliced = TestFixture::remapper(draw);
    TestFixture::observe(sliced, log);
    auto whole = sliced;
    const Correction correction = TestFixture::correction(draw);
    sliced.correct(correction);
    while (!sliced.replay([] { return false; })) {
    }
    whole.correct(correction);
    whole.finish();
    EXPECT_TRUE(TypeParam::equal(sliced.map(), whole.map())) << "seed " << seed;
  }
}

TYPED_TEST(MapperLaws, CopyIsEqualAndIndependent) {
  for (std::uint32_t seed = 0; seed < TestFixture::kSeeds; ++seed) {
    TypeParam draw(seed);
    const auto log = TestFixture::log(draw);
    typename TypeParam::Mapper map(draw.options());
    for (const auto& entry : log) map.insert(entry.z, entry.T_odom_sensor);
    const typename TypeParam::Mapper copy = map;
    EXPECT_TRUE(TypeParam::equal(map, copy)) << "seed " << seed;
    for (const auto& entry : log) map.insert(entry.z, entry.T_odom_sensor);
    typename TypeParam::Mapper again(draw.options());
    for (const auto& entry : log) again.insert(entry.z, entry.T_odom_sensor);
    EXPECT_TRUE(TypeParam::equal(copy, again)) << "seed " << seed;
  }
}

TYPED_TEST(MapperLaws, LogThatOverflowsGivesTheSameMapWithoutCorrection) {
  for (std::uint32_t seed = 0; seed < TestFixture::kSeeds; ++seed) {
    TypeParam draw(seed);
    const auto log = TestFixture::log(draw);
    auto small = TestFixture::remapper(draw, 1e-9);
    TestFixture::observe(small, log);
    auto large = TestFixture::remapper(draw);
    TestFixture::observe(large, log);
    EXPECT_EQ(small.log_size(), 0U);
    EXPECT_TRUE(TypeParam::equal(small.map(), large.map())) << "seed " << seed;
  }
}

}  // namespace
}  // namespace portolan
