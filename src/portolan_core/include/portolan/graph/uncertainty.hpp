// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "portolan/graph/arc.hpp"
#include "portolan/graph/graph.hpp"

namespace portolan {

/// A relative pose T_a_b with the covariance of v in T_a_b * exp(v).
struct UncertainPose {
  Pose mean = Pose::Identity();
  TangentMatrix covariance = TangentMatrix::Zero();
};

/// T_a_c from T_a_b and an independent T_b_c, to first order.
UncertainPose operator*(const UncertainPose& T_a_b, const UncertainPose& T_b_c);

/// T_b_a from T_a_b, to first order.
UncertainPose inverse(const UncertainPose& T_a_b);

/// The map of tangents under a change of frame: T exp(v) = exp(adjoint(T) v) T.
TangentMatrix adjoint(const Pose& T);

/// [t; 2 vec(q)], the residual of an `Arc`: the tangent of a small motion.
Tangent small_motion(const Pose& T);

/// The motion of a small tangent.
Pose motion(const Tangent& v);

/// The inverse in the directions that count in this space, zero in the others. What is not known
/// at all comes out as a variance of 1e6 [m^2 or rad^2].
TangentMatrix covariance_of(const TangentMatrix& information, GraphSpace space);

/// The same the other way; what is known perfectly comes out as 1e12.
TangentMatrix information_of(const TangentMatrix& covariance, GraphSpace space);

/// Both measurements of one pose as one: the mean weighted by information.
UncertainPose fused(const Arc& a, const Arc& b, GraphSpace space);

/// The squared Mahalanobis distance of v, in the directions that count.
double mahalanobis_squared(const Tangent& v, const TangentMatrix& covariance, GraphSpace space);

}  // namespace portolan
