// SPDX-License-Identifier: BSD-3-Clause
#include "graph/linear_start.hpp"

#include <algorithm>
#include <cmath>

#include "graph/chordal.hpp"

namespace portolan {

namespace {

constexpr int kMostSteps = 10;
constexpr double kSmall = 1e-2;      // turn of a last step [rad]
constexpr double kSameRatio = 1e-9;  // relative difference of ratios of weights

template <class Motion>
std::vector<double> weights(const Problem<Motion>& problem,
                            double (*of)(const typename Motion::Matrix&)) {
  std::vector<double> all;
  all.reserve(problem.terms.size());
  for (const auto& term : problem.terms) all.push_back(of(term.information));
  return all;
}

// Whether least squares with one or the other have the same solution.
bool are_proportional(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), [&](double x, double y) {
    return std::abs(x * b.front() - y * a.front()) <= kSameRatio * std::abs(x * b.front());
  });
}

}  // namespace

template <class Motion>
const ArcDifferences<Motion>& LinearStart<Motion>::turns() {
  if (!turns_) turns_.emplace(problem_, pattern_, weights(problem_, Motion::turn_weight));
  return *turns_;
}

template <class Motion>
const ArcDifferences<Motion>& LinearStart<Motion>::positions() {
  if (positions_) return *positions_;
  auto weight = weights(problem_, Motion::point_weight);
  if (turns_ && are_proportional(turns_->weights(), weight)) return *turns_;
  return positions_.emplace(problem_, pattern_, std::move(weight));
}

// Turns poses about axes of the map to where what is left over along arcs adds up best. Returns
// the largest turn.
template <class Motion>
double LinearStart<Motion>::turn(States& states, const OtherWinding* winding) {
  const auto turn = turns().solve([&](std::size_t i) -> typename Motion::TurnVector {
    if (winding != nullptr && winding->term == i) {
      return Motion::TurnVector::Constant(-winding->turn);
    }
    const auto& term = problem_.terms[i];
    return -Motion::turn_left(states[term.from], states[term.to], term.measured);
  });
  double largest = 0.0;
  for (std::size_t node = 0; node < problem_.pose.size(); ++node) {
    const typename Motion::TurnVector its = turn.row(static_cast<Eigen::Index>(node)).transpose();
    auto& state = states[problem_.pose[node]];
    state = Motion::turned_on(state, its);
    largest = std::max(largest, its.norm());
  }
  return largest;
}

template <>
bool LinearStart<PlanarMotion>::orient(States& states) {
  if (!turns().is_determined()) return false;
  turn(states, nullptr);
  return true;
}

template <>
bool LinearStart<SpatialMotion>::orient(States& states) {
  return orient_by_matrices(problem_, pattern_, states);
}

template <class Motion>
bool LinearStart<Motion>::rewind(const OtherWinding& winding, States& states) {
  if (!turns().is_determined()) return false;
  turn(states, &winding);
  return true;
}

template <class Motion>
bool LinearStart<Motion>::average_turns(States& states) {
  if (!turns().is_determined()) return false;
  for (int i = 0; i < kMostSteps && turn(states, nullptr) > kSmall; ++i) {
  }
  return true;
}

// t_to = t_from + R_from t_measured.
template <class Motion>
bool LinearStart<Motion>::put_in_place(States& states) {
  if (!positions().is_determined()) return false;
  const auto moved = positions().solve([&](std::size_t i) -> typename Motion::Point {
    const auto& term = problem_.terms[i];
    const auto& from = states[term.from];
    return from.t + Motion::turn(from) * term.measured.t - states[term.to].t;
  });
  for (std::size_t node = 0; node < problem_.pose.size(); ++node) {
    states[problem_.pose[node]].t += moved.row(static_cast<Eigen::Index>(node)).transpose();
  }
  return true;
}

template class LinearStart<PlanarMotion>;
template class LinearStart<SpatialMotion>;

}  // namespace portolan
