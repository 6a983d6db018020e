// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/graph_optimizer.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "graph/doubts.hpp"
#include "graph/gauss_newton.hpp"
#include "graph/linear_start.hpp"
#include "graph/winding.hpp"

namespace portolan {

namespace {

constexpr double kSame = 1e-3;       // relative difference of costs that counts as the same minimum
constexpr double kSingular = 1e-12;  // pivot, relative
constexpr double kSigmas = 5.0;      // that a loop's turns may be off, with arcs as they fit
constexpr std::size_t kMostWindings = 6;
constexpr double kTurnedFar = 0.25 * M_PI;  // arcs, in a minimum that takes little to confirm [rad]
constexpr double kGraduation = 2.0;         // from one kernel to the next, less convex one

// One optimisation of one graph.
template <class Motion>
class Run {
 public:
  Run(const Graph& graph, const OptimizerOptions& options)
      : graph_(graph),
        options_(options),
        tree_(spanning_tree(graph)),
        problem_(graph, tree_),
        given_(problem_.states(graph)),
        pattern_(Neighbours(static_cast<int>(problem_.pose.size()), problem_.pairs)),
        loops_(problem_, tree_),
        linear_(problem_, pattern_),
        solver_(problem_, pattern_) {
    kernel_.shape = options.kernel;
    kernel_.width2 = options.kernel_width * options.kernel_width;
    given_cost_ = cost(problem_, given_, kernel_);
    report_.chi2_before = chi2(given_, given_cost_);
  }

  // From the best start and then, for a second opinion, from the next best: in `best` always, else
  // where there is something to doubt.
  OptimizerReport run(Graph& graph) {
    std::vector<Start> starts = this->starts();
    Result best = descend(starts.front(), nullptr);
    bool disputed = false;
    const bool ask = options_.start == GraphStart::best || !looks_right(best);
    std::vector<OtherWinding> others = likely_windings(best);
    for (std::size_t i = 1; ask && i < starts.size() && (i < 2 || disputed); ++i) {
      if (others.empty() && is_confirmed_by(starts[i], best)) continue;
      Result other = descend(starts[i], &best);
      if (!differs(other, best)) continue;
      disputed = true;
      if (best.descent.cost <= other.descent.cost) continue;
      best = std::move(other);
      others = likely_windings(best);
    }
    if (ask) disputed = rewind(best, std::move(others)) || disputed;
    doubt(Doubt::other_minimum, disputed);
    conclude(best, graph);
    return std::move(report_);
  }

 private:
  using States = typename GaussNewton<Motion>::States;
  struct Start {
    GraphStart kind;
    States states;
    double cost;
  };
  struct Result {
    GraphStart start;
    States states;
    typename GaussNewton<Motion>::Descent descent;
    std::vector<double> turns;  // round loops
  };

  // The one that was asked for first, then by increasing cost. Given poses can be anything, so
  // that they come last unless they are the best.
  std::vector<Start> starts() {
    std::vector<Start> all;
    const auto offer = [&](GraphStart kind, States states) {
      const double its_cost = cost(problem_, states, kernel_);
      all.push_back({kind, std::move(states), its_cost});
    };
    States along = given_;
    for (const std::size_t pose : tree_.order) follow(pose, along);
    States oriented = along;
    if (linear_.orient(oriented) && linear_.put_in_place(oriented)) {
      offer(GraphStart::rotations, std::move(oriented));
    }
    offer(GraphStart::spanning_tree, std::move(along));
    all.push_back({GraphStart::as_given, given_, given_cost_});
    const auto by_cost = [](const Start& a, const Start& b) { return a.cost < b.cost; };
    std::stable_sort(all.begin(), all.end() - 1, by_cost);
    const auto wanted = [&](const Start& start) { return start.kind == options_.start; };
    auto first = std::find_if(all.begin(), all.end(), wanted);
    if (first == all.end()) first = std::min_element(all.begin(), all.end(), by_cost);
    std::rotate(all.begin(), first, first + 1);
    return all;
  }

  // Puts a pose where the tree's arc leads from its parent.
  void follow(std::size_t pose, States& states) const {
    if (tree_.parent[pose] == SpanningTree::kNone) return;
    const Arc& arc = graph_.arcs()[tree_.arc_to[pose]];
    const auto T_from_to = Motion::state(arc.T_from_to);
    const bool forward = arc.to == graph_.poses()[pose].id;
    states[pose] = Motion::composed(states[tree_.parent[pose]],
                                    forward ? T_from_to : Motion::inverse(T_from_to));
  }

  // Whether turns alone lead to the same orientations from a start and from a minimum that leaves
  // no arc turned far off: positions would follow. If not, the start is where they lead. With a
  // kernel positions do not follow.
  bool is_confirmed_by(Start& start, const Result& best) {
    if (!is_plain()) return false;
    if (are_turned_alike(problem_, start.states, best.states)) return true;
    if (is_turned_beyond(kTurnedFar, problem_, best.states)) return false;
    States turned = start.states;
    if (do_turns_lead_to(best, turned)) return true;
    if (linear_.put_in_place(turned)) {
      start.cost = cost(problem_, turned, kernel_);
      start.states = std::move(turned);
    }
    return false;
  }

  // In the plane turns are linear as soon as it is known how loops are wound: those that are wound
  // alike end alike.
  bool do_turns_lead_to(const Result& best, States& turned) {
    if constexpr (Motion::kTurns == 1) {
      if (are_wound_alike(loops_.turns(turned), best.turns)) return true;
      linear_.orient(turned);
      return false;
    } else {
      States known = best.states;
      return linear_.average_turns(known) && linear_.average_turns(turned) &&
             are_turned_alike(problem_, turned, known);
    }
  }

  // Winds loops the other way whose headings would not mind much, the likeliest first. What is
  // better then is another minimum; what could not be tried leaves a doubt.
  bool rewind(Result& best, std::vector<OtherWinding> others) {
    bool better = false;
    std::set<std::size_t> tried;
    while (const auto other = first_but(tried, others)) {
      doubt(Doubt::wound_up, tried.size() == kMostWindings);
      if (tried.size() == kMostWindings) break;
      tried.insert(other->term);
      States states = best.states;
      if (!linear_.rewind(*other, states) || !linear_.put_in_place(states)) continue;
      const double its_cost = cost(problem_, states, kernel_);
      Result result = descend({best.start, std::move(states), its_cost}, &best);
      if (!differs(result, best) || best.descent.cost < result.descent.cost) continue;
      best = std::move(result);
      others = likely_windings(best);
      better = true;
    }
    return better;
  }

  std::vector<OtherWinding> likely_windings(const Result& best) const {
    const auto degrees = static_cast<double>(std::max<std::size_t>(degrees_of_freedom(), 1));
    const double price = kSigmas * kSigmas * best.descent.cost / degrees;
    return loops_.other_windings(best.states, best.turns, price);
  }

  static std::optional<OtherWinding> first_but(const std::set<std::size_t>& tried,
                                               const std::vector<OtherWinding>& others) {
    const auto found = std::find_if(others.begin(), others.end(), [&](const OtherWinding& other) {
      return tried.count(other.term) == 0;
    });
    return found == others.end() ? std::nullopt : std::optional<OtherWinding>(*found);
  }

  bool differs(const Result& a, const Result& b) const {
    return !a.descent.known &&
           std::abs(a.descent.cost - b.descent.cost) > kSame * b.descent.cost + rounding();
  }

  // Graduated kernels begin so convex that every arc counts, and end as they were asked for.
  Result descend(const Start& start, const Result* known) {
    Result result{start.kind, start.states, {}, {}};
    double its_cost = start.cost;
    typename GaussNewton<Motion>::Limits limits{options_.max_iterations, options_.tolerance};
    if (kernel_.shape == RobustKernel::geman_mcclure) {
      Kernel kernel = kernel_;
      kernel.convexity = std::max(1.0, largest_residual(result.states) / kernel.width2);
      for (; kernel.convexity > 1.0; kernel.convexity /= kGraduation) {
        solver_.descend(result.states, cost(problem_, result.states, kernel), kernel,
                        {2, options_.tolerance});
      }
      its_cost = cost(problem_, result.states, kernel_);
    }
    if (known != nullptr) {
      limits.known_minimum = known->descent.cost;
      // With a kernel, positions do not follow from turns.
      if (is_plain()) limits.known = &known->states;
    }
    result.descent = solver_.descend(result.states, its_cost, kernel_, limits);
    report_.iterations += result.descent.iterations;
    report_.factorizations += result.descent.factorizations;
    result.turns = loops_.turns(result.states);
    return result;
  }

  bool is_plain() const { return kernel_.shape == RobustKernel::none; }

  // Of coordinates of which the cost is known.
  double chi2(const States& states, double its_cost) const {
    return is_plain() ? its_cost : cost(problem_, states, Kernel());
  }

  double largest_residual(const States& states) const {
    double largest = 0.0;
    for (const auto& term : problem_.terms) largest = std::max(largest, chi2(term, states));
    return largest;
  }

  double chi2(const typename Problem<Motion>::Term& term, const States& states) const {
    const auto r = Motion::residual(states[term.from], states[term.to], term.measured);
    return r.dot(term.information * r);
  }

  std::size_t degrees_of_freedom() const {
    const std::size_t n = Motion::kSize;
    const std::size_t measured = n * problem_.terms.size();
    const std::size_t unknown = n * problem_.pose.size();
    return measured > unknown ? measured - unknown : 0;
  }

  double rounding() const { return 1e-9 * static_cast<double>(problem_.terms.size()); }

  bool looks_right(const Result& result) const {
    return result.descent.converged && result.descent.smallest_pivot > kSingular &&
           !is_poor_fit(result.descent.cost, degrees_of_freedom(), options_.poor_fit) &&
           !is_wound_up(result);
  }

  // Coordinates look like a wrong minimum whatever the weights of the arcs.
  bool is_wound_up(const Result& result) const {
    return portolan::is_wound_up(result.turns) || is_turned_beyond(M_PI_2, problem_, result.states);
  }

  void doubt(Doubt doubt, bool holds) {
    if (holds) report_.doubts.insert(doubt);
  }

  void conclude(const Result& best, Graph& graph) {
    report_.start = best.start;
    report_.cost = best.descent.cost;
    report_.chi2 = chi2(best.states, best.descent.cost);
    report_.degrees_of_freedom = degrees_of_freedom();
    doubt(Doubt::not_converged, !best.descent.converged);
    doubt(Doubt::undetermined, best.descent.smallest_pivot < kSingular);
    doubt(Doubt::disconnected, is_disconnected(graph_, tree_));
    doubt(Doubt::bad_information, problem_.has_bad_information);
    doubt(Doubt::poor_fit, is_poor_fit(best.descent.cost, degrees_of_freedom(), options_.poor_fit));
    doubt(Doubt::wound_up, is_wound_up(best));
    report_.weights.assign(graph.arcs().size(), 0.0);
    for (std::size_t i = 0; i < problem_.terms.size(); ++i) {
      const auto& term = problem_.terms[i];
      report_.weights[problem_.arc[i]] =
          term.may_fail && !is_plain() ? kernel_.weight(chi2(term, best.states)) : 1.0;
    }
    for (const std::size_t pose : problem_.pose) graph.move(pose, Motion::pose(best.states[pose]));
  }

  const Graph& graph_;
  const OptimizerOptions& options_;
  SpanningTree tree_;
  Problem<Motion> problem_;
  States given_;
  BlockPattern pattern_;
  Loops<Motion> loops_;
  LinearStart<Motion> linear_;
  GaussNewton<Motion> solver_;
  Kernel kernel_;
  double given_cost_ = 0.0;
  OptimizerReport report_;
};

}  // namespace

GraphOptimizer::GraphOptimizer(const Options& options) : options_(checked(options)) {}

OptimizerReport GraphOptimizer::optimize(Graph& graph) const {
  return graph.space() == GraphSpace::planar ? Run<PlanarMotion>(graph, options_).run(graph)
                                             : Run<SpatialMotion>(graph, options_).run(graph);
}

}  // namespace portolan
