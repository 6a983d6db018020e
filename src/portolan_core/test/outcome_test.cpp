// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/outcome.hpp"

#include <gtest/gtest.h>

#include "portolan/options/value.hpp"

namespace portolan {
namespace {

TEST(Outcome, NamesStandInTheOrderOfTheEnumerators) {
  EXPECT_EQ(options_detail::format(Outcome::inserted), "inserted");
  EXPECT_EQ(options_detail::format(Outcome::rejected), "rejected");
  EXPECT_EQ(options_detail::format(Outcome::unusable), "unusable");
}

}  // namespace
}  // namespace portolan
