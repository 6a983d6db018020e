// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/odometry_covariances.hpp"

#include <iterator>

#include "portolan_ros/convert/basics.hpp"

namespace portolan {

void OdometryCovariances::receive(const nav_msgs::Odometry& message, const std::string& frame) {
  using RowMajor = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
  const PoseCovariance covariance = Eigen::Map<const RowMajor>(message.pose.covariance.data());
  const bool is_known = is_stated(covariance);
  if (!is_known && stated_.empty()) return;  // most drivers state none: nothing to remember
  stated_[ros_convert::time(message.header.stamp)] =
      is_known ? std::optional<Stated>({frame, covariance}) : std::nullopt;
  const Time newest = stated_.rbegin()->first;
  while (stated_.begin()->first < newest - remembered_) stated_.erase(stated_.begin());
}

std::optional<OdometryCovariances::Stated> OdometryCovariances::at(Time stamp) const {
  const auto after = stated_.upper_bound(stamp);
  return after == stated_.begin() ? std::nullopt : std::prev(after)->second;
}

}  // namespace portolan
