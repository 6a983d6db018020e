// SPDX-License-Identifier: BSD-3-Clause
#include "graph/linear_start.hpp"

#include <gtest/gtest.h>

#include <random>

#include "graph/normal_equations.hpp"
#include "graph/random_graph.hpp"

namespace portolan {
namespace {

template <class Motion>
class LinearStartTest : public ::testing::Test {
 protected:
  using States = typename LinearStart<Motion>::States;

  // Calls `check(problem, start, states)` for walks whose arcs can all agree, with poses turned by
  // up to an angle from there.
  template <class Check>
  static void for_walks(double most, const Check& check) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      std::mt19937_64 random(seed);
      RandomGraph made;
      made.space = Motion::kSize == 3 ? GraphSpace::planar : GraphSpace::spatial;
      made.noise = 0.0;
      const RandomGraph::Walk walk = made.walk(random);
      const Problem<Motion> problem(walk.graph, spanning_tree(walk.graph));
      const BlockPattern pattern(Neighbours(static_cast<int>(problem.pose.size()), problem.pairs));
      LinearStart<Motion> start(problem, pattern);
      States states = problem.states(walk.graph);
      std::uniform_real_distribution<double> angle(-most, most);
      for (const std::size_t pose : problem.pose) {
        typename Motion::TurnVector turn;
        for (int axis = 0; axis < Motion::kTurns; ++axis) turn[axis] = angle(random);
        states[pose] = Motion::turned_on(states[pose], turn);
      }
      check(problem, start, states);
    }
  }

  static void expect_agreement(const Problem<Motion>& problem, const States& states) {
    for (const auto& term : problem.terms) {
      EXPECT_LT(Motion::angle_left(states[term.from], states[term.to], term.measured), 1e-3);
    }
  }
};

using Motions = ::testing::Types<PlanarMotion, SpatialMotion>;
TYPED_TEST_SUITE(LinearStartTest, Motions, );

// By a last step of 0.01 rad they nearly do.
TYPED_TEST(LinearStartTest, averages_turns_until_they_agree_and_leaves_positions) {
  this->for_walks(0.3, [&](const auto& problem, auto& start, auto& states) {
    const auto before = states;
    ASSERT_TRUE(start.average_turns(states));
    this->expect_agreement(problem, states);
    for (std::size_t i = 0; i < states.size(); ++i) EXPECT_EQ(states[i].t, before[i].t);
  });
}

TYPED_TEST(LinearStartTest, orients_and_puts_in_place_where_nothing_is_left) {
  this->for_walks(0.3, [&](const auto& problem, auto& start, auto& states) {
    for (const std::size_t pose : problem.pose) states[pose].t.setConstant(7.0);
    ASSERT_TRUE(start.orient(states));
    this->expect_agreement(problem, states);
    ASSERT_TRUE(start.put_in_place(states));
    EXPECT_LT(cost(problem, states, Kernel()), 1e-12);
  });
}

// A loop of four quarter turns that is wound the other way shares out a whole turn.
TEST(LinearStart, winds_a_loop_the_other_way) {
  Graph graph;
  for (PoseId id = 0; id < 4; ++id) {
    GraphPose pose;
    pose.id = id;
    graph.add(pose);
  }
  for (PoseId id = 0; id < 4; ++id) {
    Arc arc;
    arc.from = id;
    arc.to = (id + 1) % 4;
    arc.T_from_to = planar_pose(1.0, 0.0, M_PI_2);
    graph.add(arc);
  }
  const SpanningTree tree = spanning_tree(graph);
  const Problem<PlanarMotion> problem(graph, tree);
  const Loops<PlanarMotion> loops(problem, tree);
  const BlockPattern pattern(Neighbours(3, problem.pairs));
  LinearStart<PlanarMotion> start(problem, pattern);
  place_along(tree, graph);
  const auto states = problem.states(graph);
  const std::vector<double> turns = loops.turns(states);
  ASSERT_EQ(turns.size(), 1U);
  EXPECT_NEAR(turns[0], 0.0, 1e-12);
  auto wound = states;
  ASSERT_TRUE(start.rewind({3, 2.0 * M_PI, 0.0}, wound));
  for (const auto& term : problem.terms) {
    EXPECT_NEAR(PlanarMotion::angle_left(wound[term.from], wound[term.to], term.measured), M_PI_2,
                1e-9);
  }
  EXPECT_FALSE(are_wound_alike(turns, loops.turns(wound)));
  EXPECT_TRUE(is_wound_up(loops.turns(wound)));
}

}  // namespace
}  // namespace portolan
