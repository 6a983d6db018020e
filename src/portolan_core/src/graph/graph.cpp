// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/graph.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <stdexcept>
#include <string>

namespace portolan {

namespace {

constexpr double kRounding = 1e-9;  // of eigenvalues, relative to the largest entry

template <class Matrix>
bool is_information(const Matrix& information) {
  const double size = information.cwiseAbs().maxCoeff();
  if (!information.allFinite()) return false;
  if ((information - information.transpose()).cwiseAbs().maxCoeff() > kRounding * size)
    return false;
  const Matrix lifted = information + kRounding * size * Matrix::Identity();
  return size == 0.0 || Eigen::LLT<Matrix>(lifted).info() == Eigen::Success;
}

Eigen::Matrix3d planar(const TangentMatrix& m) {
  Eigen::Matrix3d p;
  p << m.topLeftCorner<2, 2>(), m.block<2, 1>(0, 5), m.block<1, 2>(5, 0), m(5, 5);
  return p;
}

bool is_information(const TangentMatrix& information, GraphSpace space) {
  return space == GraphSpace::planar ? is_information(planar(information))
                                     : is_information<TangentMatrix>(information);
}

bool has_lower_id(const GraphPose& pose, PoseId id) { return pose.id < id; }

[[noreturn]] void refuse(const std::string& why) { throw std::invalid_argument(why); }

}  // namespace

void Graph::add(const GraphPose& pose) {
  const auto place = std::lower_bound(poses_.begin(), poses_.end(), pose.id, has_lower_id);
  const std::string name = "pose " + std::to_string(pose.id);
  if (place != poses_.end() && place->id == pose.id) refuse(name + " is there already");
  if (!is_valid(pose.T_map_pose)) refuse(name + " is not rigid");
  poses_.insert(place, pose);
}

std::size_t Graph::add(const Arc& arc) {
  const std::string name = "arc " + std::to_string(arc.from) + " -> " + std::to_string(arc.to);
  if (!find(arc.from) || !find(arc.to)) refuse(name + ": no such pose");
  if (arc.from == arc.to) refuse(name + " leads nowhere");
  if (!is_valid(arc.T_from_to)) refuse(name + " is not rigid");
  arcs_.push_back(arc);
  if (!is_information(arc.information, space_)) {
    set_state(arcs_.size() - 1, ArcState::rejected, ArcReason::bad_information);
  }
  return arcs_.size() - 1;
}

// Most ids have no gaps: there the place is known.
std::optional<std::size_t> Graph::find(PoseId id) const {
  if (poses_.empty() || id < poses_.front().id) return std::nullopt;
  const std::size_t guess =
      static_cast<std::size_t>(id) - static_cast<std::size_t>(poses_.front().id);
  if (guess < poses_.size() && poses_[guess].id == id) return guess;
  const auto place = std::lower_bound(poses_.begin(), poses_.end(), id, has_lower_id);
  if (place == poses_.end() || place->id != id) return std::nullopt;
  return static_cast<std::size_t>(place - poses_.begin());
}

const GraphPose& Graph::at(PoseId id) const {
  const std::optional<std::size_t> place = find(id);
  if (!place) throw std::out_of_range("no pose " + std::to_string(id));
  return poses_[*place];
}

void Graph::set_state(std::size_t arc, ArcState state, ArcReason reason) {
  Arc& changed = arcs_.at(arc);
  changed.state = state;
  changed.reason = reason;
}

}  // namespace portolan
