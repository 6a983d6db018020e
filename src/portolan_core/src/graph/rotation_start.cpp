// SPDX-License-Identifier: BSD-3-Clause
#include "graph/rotation_start.hpp"

#include "graph/linear_least_squares.hpp"

namespace portolan {

namespace {

// X = R^T: R_to = R_from Z.
template <class Motion>
bool orient(const Problem<Motion>& problem, const BlockPattern& pattern,
            std::vector<typename Motion::State>& states) {
  using Turns = LinearLeastSquares<Motion::kSpace, Motion::kTurnColumns>;
  using Unknown = typename Turns::Unknown;
  Turns turns(problem);
  const auto fixed = [&](std::size_t pose) -> Unknown {
    return Motion::turn(states[pose]).transpose().template leftCols<Motion::kTurnColumns>();
  };
  for (const auto& term : problem.terms) {
    turns.add(term, problem.node, Motion::turn_weight(term.information),
              Motion::turn(term.measured), Unknown(Unknown::Zero()), fixed);
  }
  if (!turns.solve(pattern)) return false;
  for (std::size_t i = 0; i < problem.pose.size(); ++i) {
    auto& state = states[problem.pose[i]];
    state = Motion::with_turn(state, turns.at_node(static_cast<int>(i)));
  }
  return true;
}

}  // namespace

// t_to = t_from + R_from t_measured.
template <class Motion>
bool put_in_place(const Problem<Motion>& problem, const BlockPattern& pattern,
                  std::vector<typename Motion::State>& states) {
  using Positions = LinearLeastSquares<1, Motion::kSpace>;
  Positions positions(problem);
  const auto fixed = [&](std::size_t pose) ->
      typename Positions::Unknown { return states[pose].t.transpose(); };
  const typename Positions::Block one = Positions::Block::Identity();
  for (const auto& term : problem.terms) {
    const typename Motion::Point step = Motion::turn(states[term.from]) * term.measured.t;
    positions.add(term, problem.node, Motion::point_weight(term.information), one,
                  typename Positions::Unknown(step.transpose()), fixed);
  }
  if (!positions.solve(pattern)) return false;
  for (std::size_t i = 0; i < problem.pose.size(); ++i) {
    states[problem.pose[i]].t = positions.at_node(static_cast<int>(i)).transpose();
  }
  return true;
}

template <class Motion>
std::optional<std::vector<typename Motion::State>> rotation_start(
    const Problem<Motion>& problem, const BlockPattern& pattern,
    std::vector<typename Motion::State> states) {
  if (!orient(problem, pattern, states)) return std::nullopt;
  if (!put_in_place(problem, pattern, states)) return std::nullopt;
  return states;
}

template bool put_in_place(const Problem<PlanarMotion>&, const BlockPattern&,
                           std::vector<PlanarMotion::State>&);
template bool put_in_place(const Problem<SpatialMotion>&, const BlockPattern&,
                           std::vector<SpatialMotion::State>&);
template std::optional<std::vector<PlanarMotion::State>> rotation_start(
    const Problem<PlanarMotion>&, const BlockPattern&, std::vector<PlanarMotion::State>);
template std::optional<std::vector<SpatialMotion::State>> rotation_start(
    const Problem<SpatialMotion>&, const BlockPattern&, std::vector<SpatialMotion::State>);

}  // namespace portolan
