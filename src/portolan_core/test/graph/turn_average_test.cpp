// SPDX-License-Identifier: BSD-3-Clause
#include "graph/turn_average.hpp"

#include <gtest/gtest.h>

#include <random>

#include "graph/random_graph.hpp"

namespace portolan {
namespace {

template <class Motion>
class TurnAverage : public ::testing::Test {};

using Motions = ::testing::Types<PlanarMotion, SpatialMotion>;
TYPED_TEST_SUITE(TurnAverage, Motions, );

// Without noise all turns can agree, and by a last step of 0.01 rad they nearly do.
TYPED_TEST(TurnAverage, finds_turns_that_agree_and_leaves_positions) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    std::mt19937_64 random(seed);
    RandomGraph made;
    made.space = TypeParam::kSize == 3 ? GraphSpace::planar : GraphSpace::spatial;
    made.noise = 0.0;
    const Graph graph = made.walk(random).graph;
    const Problem<TypeParam> problem(graph, spanning_tree(graph));
    auto states = problem.states(graph);
    std::uniform_real_distribution<double> angle(-0.3, 0.3);
    for (const std::size_t pose : problem.pose) {
      typename TypeParam::TurnVector turn;
      for (int axis = 0; axis < TypeParam::kTurns; ++axis) turn[axis] = angle(random);
      states[pose] = TypeParam::turned_on(states[pose], turn);
    }
    const auto before = states;
    const BlockPattern pattern(Neighbours(static_cast<int>(problem.pose.size()), problem.pairs));
    ASSERT_TRUE(average_turns(problem, pattern, states));
    for (const auto& term : problem.terms) {
      EXPECT_LT(TypeParam::angle_left(states[term.from], states[term.to], term.measured), 1e-3);
    }
    for (std::size_t i = 0; i < states.size(); ++i) EXPECT_EQ(states[i].t, before[i].t);
  }
}

}  // namespace
}  // namespace portolan
