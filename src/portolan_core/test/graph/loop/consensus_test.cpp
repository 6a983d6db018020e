// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/loop/consensus.hpp"

#include <gtest/gtest.h>

#include <random>

namespace portolan {
namespace {

TangentMatrix planar_covariance(double position, double heading) {
  TangentMatrix covariance = TangentMatrix::Zero();
  covariance.diagonal() << position * position, position * position, 0, 0, 0, heading * heading;
  return covariance;
}

UncertainPose noisy(const Pose& T, double position, double heading, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const Pose error =
      planar_pose(position * normal(random), position * normal(random), heading * normal(random));
  return {T * error, planar_covariance(position, heading)};
}

// Twice round a square of ten metres in steps of one, and loops from each place to its return.
struct Square {
  Chain chain{GraphSpace::planar};
  std::vector<Link> loops;
};

Square twice_round(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Square square;
  std::vector<Pose> truth = {Pose::Identity()};
  square.chain.add({});
  for (std::size_t i = 1; i <= 80; ++i) {
    const Pose step = planar_pose(1.0, 0.0, i % 10 == 0 ? M_PI_2 : 0.0);
    truth.push_back(truth.back() * step);
    square.chain.add(noisy(step, 0.02, 0.01, random));
  }
  for (std::size_t i = 0; i < 20; i += 2) {
    const Pose T = truth[i].inverse() * truth[i + 40];
    square.loops.push_back({i, i + 40, noisy(T, 0.05, 0.02, random)});
  }
  return square;
}

TEST(Chain, GivesTheWayBetweenAnyTwo) {
  const Square square = twice_round(1);
  UncertainPose way;
  std::mt19937_64 random(1);
  Chain chain(GraphSpace::planar);
  std::vector<UncertainPose> steps(1);
  chain.add({});
  for (std::size_t i = 1; i < 30; ++i) {
    steps.push_back(noisy(planar_pose(1.0, 0.1, 0.2), 0.02, 0.01, random));
    chain.add(steps.back());
  }
  for (std::size_t i = 11; i <= 25; ++i) way = way * steps[i];
  EXPECT_TRUE(chain.between(10, 25).mean.isApprox(way.mean, 1e-9));
  EXPECT_TRUE(chain.between(10, 25).covariance.isApprox(way.covariance, 1e-9));
  EXPECT_TRUE(chain.between(25, 10).mean.isApprox(inverse(way).mean, 1e-9));
  EXPECT_TRUE(chain.between(25, 10).covariance.isApprox(inverse(way).covariance, 1e-9));
  EXPECT_TRUE(chain.between(7, 7).covariance.isZero(1e-12));
}

TEST(Consensus, DisagreementIsChiSquared) {
  double mean = 0.0;
  constexpr int kSeeds = 200;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const Square square = twice_round(seed);
    mean += disagreement(square.loops[1], square.loops[7], square.chain) / kSeeds;
  }
  EXPECT_GT(mean, 2.5);
  EXPECT_LT(mean, 3.5);
}

TEST(Consensus, LeavesOutWrongLoops) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Square square = twice_round(seed);
    for (const std::size_t wrong : {2UL, 5UL}) {
      Pose& T = square.loops[wrong].T_from_to.mean;
      T = T * planar_pose(1.5, 0.0, 0.0);
    }
    const std::vector<std::size_t> clique = consensus(square.loops, 0, square.chain);
    EXPECT_GE(clique.size(), 7U) << "seed " << seed;
    for (const std::size_t i : clique) EXPECT_TRUE(i != 2 && i != 5) << "seed " << seed;
    EXPECT_LE(consensus(square.loops, 2, square.chain).size(), 2U) << "seed " << seed;
  }
}

TEST(Reckoning, TakesTheSurestWay) {
  const auto link = [](std::size_t from, std::size_t to, double x, double deviation) {
    return Link{from, to, {planar_pose(x, 0, 0), planar_covariance(deviation, 0.0)}};
  };
  // 0 - 1 - 2 in sure steps, 0 - 2 in a vague one that says otherwise; 3 is alone.
  const std::vector<Link> links = {link(0, 1, 1.0, 0.1), link(2, 1, -1.0, 0.1), link(0, 2, 5, 1.0)};
  const auto T = reckon(links, 4, 0);
  ASSERT_TRUE(T[2]);
  EXPECT_NEAR(T[2]->mean.translation().x(), 2.0, 1e-12);
  EXPECT_NEAR(T[2]->covariance(0, 0), 0.02, 1e-12);
  EXPECT_FALSE(T[3]);
}

}  // namespace
}  // namespace portolan
