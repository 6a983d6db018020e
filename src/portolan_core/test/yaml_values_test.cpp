// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/yaml_values.hpp"

#include <gtest/gtest.h>

namespace portolan::yaml_values {
namespace {

std::string fault(const std::string& yaml) {
  try {
    covariance(YAML::Load(yaml), "Q");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(YamlValues, WhatIsListedIsReadAgainToTheLastBit) {
  Eigen::Matrix3d Q;
  Q << 2.0, 0.1, -0.3, 0.1, 1.0 / 3.0, 0.0, -0.3, 0.0, 0.7;
  EXPECT_EQ(covariance(YAML::Load(listed(Q)), "Q"), Q);
  const Eigen::Vector3d p(1.0 / 7.0, -1e300, 5e-324);
  EXPECT_EQ((matrix<3, 1>(YAML::Load(listed(p)), "p")), p);
}

TEST(YamlValues, WhatIsNoCovarianceIsRefusedByName) {
  EXPECT_EQ(fault("[1, 0, 0, 0, 1, 0, 0, 0]"), "Q must have 9 numbers");
  EXPECT_EQ(fault("{}"), "Q must have 9 numbers");
  EXPECT_EQ(fault("[1, 0, 0, 0, .nan, 0, 0, 0, 1]"), "Q is not finite");
  EXPECT_EQ(fault("[1, 0, 0, 0, [1], 0, 0, 0, 1]"), "Q is missing");
  EXPECT_EQ(fault("[1, 0.5, 0, 0, 1, 0, 0, 0, 1]"), "Q is not symmetric");
  EXPECT_EQ(fault("[1, 2, 0, 2, 1, 0, 0, 0, 1]"), "Q has negative eigenvalues");
  EXPECT_EQ(fault("[0, 0, 0, 0, 0, 0, 0, 0, 0]"), "");
}

}  // namespace
}  // namespace portolan::yaml_values
