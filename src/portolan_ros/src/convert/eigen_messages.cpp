// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/convert/eigen_messages.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace portolan::ros_convert {

void fill_ellipsoid(const geometry_msgs::Point& mean, const Eigen::Matrix3d& covariance,
                    double standard_deviations, visualization_msgs::Marker& marker) {
  constexpr double kThinnest = 0.02;  // of what is drawn [m]; rviz refuses flat ellipsoids
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  Eigen::Matrix3d axes = solver.eigenvectors();
  if (axes.determinant() < 0.0) axes.col(0) *= -1.0;
  const Eigen::Quaterniond q(axes);
  marker.pose.position = mean;
  marker.pose.orientation.x = q.x();
  marker.pose.orientation.y = q.y();
  marker.pose.orientation.z = q.z();
  marker.pose.orientation.w = q.w();
  const Eigen::Vector3d size =
      (2.0 * standard_deviations * solver.eigenvalues().cwiseMax(0.0).cwiseSqrt())
          .cwiseMax(kThinnest);
  marker.scale.x = size.x();
  marker.scale.y = size.y();
  marker.scale.z = size.z();
}

}  // namespace portolan::ros_convert
