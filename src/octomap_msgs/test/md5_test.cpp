// SPDX-License-Identifier: BSD-3-Clause
// Whoever was built against the published messages talks to ours only while the MD5 sums agree.
#include <gtest/gtest.h>
#include <octomap_msgs/BoundingBoxQuery.h>
#include <octomap_msgs/GetOctomap.h>
#include <octomap_msgs/Octomap.h>
#include <octomap_msgs/OctomapWithPose.h>

namespace {

template <class Message>
std::string message_md5() {
  return ros::message_traits::MD5Sum<Message>::value();
}

template <class Service>
std::string service_md5() {
  return ros::service_traits::MD5Sum<Service>::value();
}

TEST(Md5, IsThatOfThePublishedDefinitions) {
  EXPECT_EQ(message_md5<octomap_msgs::Octomap>(), "9a45536b45c5e409cd49f04bb2d9999f");
  EXPECT_EQ(message_md5<octomap_msgs::OctomapWithPose>(), "20b380aca6a508a657e95526cddaf618");
  EXPECT_EQ(service_md5<octomap_msgs::GetOctomap>(), "be9d2869d24fe40d6bc21ac21f6bb2c5");
  EXPECT_EQ(service_md5<octomap_msgs::BoundingBoxQuery>(), "93aa3d73b866f04880927745f4aab303");
}

}  // namespace
