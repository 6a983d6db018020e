// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/marginals.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "graph/normal_equations.hpp"
#include "graph/selected_inverse.hpp"

namespace portolan {

namespace {

constexpr double kSingular = 1e-12;  // pivot, relative

TangentMatrix spread(const Eigen::Matrix3d& planar) {
  TangentMatrix m = TangentMatrix::Zero();
  m.topLeftCorner<2, 2>() = planar.topLeftCorner<2, 2>();
  m.block<2, 1>(0, 5) = planar.block<2, 1>(0, 2);
  m.block<1, 2>(5, 0) = planar.block<1, 2>(2, 0);
  m(5, 5) = planar(2, 2);
  return m;
}
const TangentMatrix& spread(const TangentMatrix& spatial) { return spatial; }

// The factored information matrix of a graph at its coordinates.
template <class Motion>
class Information {
 public:
  static constexpr int kSize = Motion::kSize;
  using Matrix = typename Motion::Matrix;

  explicit Information(const Graph& graph)
      : problem_(graph, spanning_tree(graph)),
        states_(problem_.states(graph)),
        pattern_(Neighbours(static_cast<int>(problem_.pose.size()), problem_.pairs)),
        equations_(problem_),
        factor_(pattern_, problem_.pairs) {
    equations_.linearize(problem_, states_, Kernel());
    if (!factor_.factor(equations_.H) || factor_.smallest_pivot() < kSingular) {
      throw std::runtime_error("arcs leave a pose undetermined");
    }
  }
  Information(const Information&) = delete;  // the factor refers to the pattern
  Information& operator=(const Information&) = delete;

  TangentMatrix covariance(std::size_t pose) const { return spread(joint(pose, pose)); }

  // The error of T_from_to, in the frame of `to`, is H_from v_from + H_to v_to.
  TangentMatrix relative_covariance(std::size_t from, std::size_t to) const {
    const auto& a = states_[from];
    const auto& b = states_[to];
    const auto l = Motion::linearize(a, b, Motion::composed(Motion::inverse(a), b));
    const Matrix cross = l.H_from * joint(from, to) * l.H_to.transpose();
    const Matrix sum = l.H_from * joint(from, from) * l.H_from.transpose() +
                       l.H_to * joint(to, to) * l.H_to.transpose() + cross + cross.transpose();
    return spread(Matrix(0.5 * (sum + sum.transpose())));
  }

  std::vector<TangentMatrix> covariances() const {
    std::vector<TangentMatrix> all(states_.size(), TangentMatrix::Zero());
    const auto blocks = inverse_diagonal(factor_);
    for (std::size_t i = 0; i < blocks.size(); ++i) all[problem_.pose[i]] = spread(blocks[i]);
    return all;
  }

 private:
  // The block of H^-1 in the row of `a` and the column of `b`.
  Matrix joint(std::size_t a, std::size_t b) const {
    Matrix block = Matrix::Zero();
    if (problem_.node[a] < 0 || problem_.node[b] < 0) return block;
    for (int j = 0; j < kSize; ++j) {
      Eigen::VectorXd x = Eigen::VectorXd::Zero(equations_.g.size());
      x[problem_.node[b] * kSize + j] = 1.0;
      factor_.solve(x);
      block.col(j) = x.segment<kSize>(problem_.node[a] * kSize);
    }
    return block;
  }

  Problem<Motion> problem_;
  std::vector<typename Motion::State> states_;
  BlockPattern pattern_;
  NormalEquations<Motion> equations_;
  BlockCholesky<kSize> factor_;
};

template <class Motion>
using Held = std::unique_ptr<const Information<Motion>>;

}  // namespace

class Marginals::Factor {
 public:
  explicit Factor(const Graph& graph) {
    for (const GraphPose& pose : graph.poses()) ids_.push_back(pose.id);
    if (graph.space() == GraphSpace::planar) {
      information_ = std::make_unique<const Information<PlanarMotion>>(graph);
    } else {
      information_ = std::make_unique<const Information<SpatialMotion>>(graph);
    }
  }

  std::size_t index(PoseId id) const {
    const auto place = std::lower_bound(ids_.begin(), ids_.end(), id);
    if (place == ids_.end() || *place != id) {
      throw std::out_of_range("no pose " + std::to_string(id));
    }
    return static_cast<std::size_t>(place - ids_.begin());
  }

  template <class Question>
  auto ask(const Question& question) const {
    return std::visit([&](const auto& information) { return question(*information); },
                      information_);
  }

 private:
  std::vector<PoseId> ids_;
  std::variant<Held<PlanarMotion>, Held<SpatialMotion>> information_;
};

Marginals::Marginals(const Graph& graph) : factor_(std::make_unique<const Factor>(graph)) {}
Marginals::~Marginals() = default;
Marginals::Marginals(Marginals&&) noexcept = default;
Marginals& Marginals::operator=(Marginals&&) noexcept = default;

TangentMatrix Marginals::covariance(PoseId id) const {
  const std::size_t pose = factor_->index(id);
  return factor_->ask([&](const auto& information) { return information.covariance(pose); });
}

TangentMatrix Marginals::relative_covariance(PoseId from, PoseId to) const {
  const std::size_t a = factor_->index(from);
  const std::size_t b = factor_->index(to);
  return factor_->ask(
      [&](const auto& information) { return information.relative_covariance(a, b); });
}

std::vector<TangentMatrix> Marginals::covariances() const {
  return factor_->ask([](const auto& information) { return information.covariances(); });
}

}  // namespace portolan
