// SPDX-License-Identifier: BSD-3-Clause
// What the optimiser knows of motion in the plane and in space: residuals by their definition, and
// derivatives by numeric ones, however far poses are turned.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "graph/planar_motion.hpp"
#include "graph/spatial_motion.hpp"
#include "portolan/testing/numeric_jacobian.hpp"

namespace portolan {
namespace {

Pose any_pose(double length, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const Eigen::Quaterniond q(normal(random), normal(random), normal(random), normal(random));
  const Eigen::Vector3d t(normal(random), normal(random), normal(random));
  return Eigen::Translation3d(length * t) * q.normalized();
}

// A motion, its random poses, and the residual of an arc as its definition has it.
struct Planar : PlanarMotion {
  static Pose any(double length, std::mt19937_64& random) {
    std::uniform_real_distribution<double> heading(-M_PI, M_PI);
    const Pose pose = any_pose(length, random);
    return planar_pose(pose.translation().x(), pose.translation().y(), heading(random));
  }
  static Vector defined(const Pose& error) {
    return {error.translation().x(), error.translation().y(), yaw(error)};
  }
  static Vector difference(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], wrap_angle(a[2] - b[2])};
  }
};

struct Spatial : SpatialMotion {
  static Pose any(double length, std::mt19937_64& random) { return any_pose(length, random); }
  static Vector defined(const Pose& error) {
    Eigen::Quaterniond q(error.linear());
    if (q.w() < 0.0) q.coeffs() = -q.coeffs();
    Vector r;
    r << error.translation(), 2.0 * q.vec();
    return r;
  }
  static Vector difference(const Vector& a, const Vector& b) { return a - b; }
};

template <class Motion>
class MotionLaws : public ::testing::Test {
 protected:
  using State = typename Motion::State;

  struct Case {
    Pose T_map_from;
    Pose T_map_to;
    Pose T_from_to;  // as measured
    State from() const { return Motion::state(T_map_from); }
    State to() const { return Motion::state(T_map_to); }
    State measured() const { return Motion::state(T_from_to); }
    Pose error() const { return T_from_to.inverse() * T_map_from.inverse() * T_map_to; }
  };

  // Near and far from each other, near and far from what was measured; not where a half turn is
  // left, since there the residual jumps.
  template <class Check>
  static void for_any(const Check& check) {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      std::mt19937_64 random(seed);
      const double length = seed % 2 == 0 ? 1.0 : 300.0;
      Case any{Motion::any(length, random), Motion::any(length, random), {}};
      any.T_from_to =
          seed % 3 == 0 ? Motion::any(length, random) : any.T_map_from.inverse() * any.T_map_to;
      if (seed % 3 == 1) any.T_from_to = any.T_from_to * planar_pose(0.1, -0.2, 0.05);
      if (Eigen::AngleAxisd(any.error().linear()).angle() < M_PI - 0.01) check(any, seed);
    }
  }
};

using Motions = ::testing::Types<Planar, Spatial>;
TYPED_TEST_SUITE(MotionLaws, Motions, );

TYPED_TEST(MotionLaws, measure_what_is_left_of_an_arc) {
  this->for_any([](const auto& any, std::uint64_t seed) {
    const auto r = TypeParam::residual(any.from(), any.to(), any.measured());
    const auto defined = TypeParam::defined(any.error());
    EXPECT_LT(TypeParam::difference(r, defined).norm(), 1e-10) << seed;
    const auto l = TypeParam::linearize(any.from(), any.to(), any.measured());
    EXPECT_LT((l.r - r).norm(), 1e-12) << seed;
  });
}

TYPED_TEST(MotionLaws, derive_it_as_numeric_differences_do) {
  using Vector = typename TypeParam::Vector;
  this->for_any([](const auto& any, std::uint64_t seed) {
    const auto from = any.from();
    const auto to = any.to();
    const auto measured = any.measured();
    const auto l = TypeParam::linearize(from, to, measured);
    const auto by_from = testing::numeric_jacobian(
        [&](const Vector& v) {
          return TypeParam::residual(TypeParam::moved(from, v), to, measured);
        },
        Vector(Vector::Zero()), TypeParam::difference);
    const auto by_to = testing::numeric_jacobian(
        [&](const Vector& v) {
          return TypeParam::residual(from, TypeParam::moved(to, v), measured);
        },
        Vector(Vector::Zero()), TypeParam::difference);
    const double far = 1.0 + any.error().translation().norm() + any.T_from_to.translation().norm();
    EXPECT_LT((l.H_from - by_from).cwiseAbs().maxCoeff(), 1e-8 * far) << seed;
    EXPECT_LT((l.H_to - by_to).cwiseAbs().maxCoeff(), 1e-8 * far) << seed;
  });
}

TYPED_TEST(MotionLaws, compose_and_invert_as_poses_do) {
  this->for_any([](const auto& any, std::uint64_t seed) {
    const auto composed = TypeParam::composed(any.from(), any.measured());
    EXPECT_TRUE(TypeParam::pose(composed).isApprox(any.T_map_from * any.T_from_to, 1e-12)) << seed;
    const Pose inverse = TypeParam::pose(TypeParam::inverse(any.to()));
    EXPECT_TRUE(inverse.isApprox(any.T_map_to.inverse(), 1e-12)) << seed;
  });
}

TEST(SpatialMotion, finds_a_rotation_again_in_its_transpose) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    std::mt19937_64 random(seed);
    const SpatialMotion::State any = SpatialMotion::state(any_pose(2.0, random));
    const auto again = SpatialMotion::with_turn(any, 3.0 * any.R.transpose());
    EXPECT_LT((again.R - any.R).norm(), 1e-12) << seed;
  }
}

// A quaternion and its negative are the same turn: neither residual nor derivatives may see which.
TEST(SpatialMotion, does_not_see_the_sign_of_a_quaternion) {
  std::mt19937_64 random(1);
  const SpatialMotion::State from = SpatialMotion::state(any_pose(2.0, random));
  const SpatialMotion::State to = SpatialMotion::state(any_pose(2.0, random));
  const SpatialMotion::State measured = SpatialMotion::state(any_pose(2.0, random));
  const SpatialMotion::Linearized l = SpatialMotion::linearize(from, to, measured);
  for (int i = 1; i < 8; ++i) {
    const auto maybe_flipped = [&](const SpatialMotion::State& x, int bit) {
      Eigen::Quaterniond q = x.q;
      if ((i & bit) != 0) q.coeffs() = -q.coeffs();
      return SpatialMotion::turned(x.t, q);
    };
    const auto flipped = SpatialMotion::linearize(maybe_flipped(from, 1), maybe_flipped(to, 2),
                                                  maybe_flipped(measured, 4));
    EXPECT_LT((flipped.r - l.r).norm(), 1e-14);
    EXPECT_LT((flipped.H_from - l.H_from).norm(), 1e-14);
    EXPECT_LT((flipped.H_to - l.H_to).norm(), 1e-14);
  }
}

}  // namespace
}  // namespace portolan
