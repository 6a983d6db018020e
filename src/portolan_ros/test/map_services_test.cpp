// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/map_services.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>

namespace portolan {
namespace {

/// Sets HOME, or takes it away, until the end of the test.
class MapFolder : public ::testing::Test {
 protected:
  MapFolder() {
    if (const char* home = std::getenv("HOME")) before_ = home;
  }
  ~MapFolder() override { set_home(before_); }

  static void set_home(const std::optional<std::string>& home) {
    home ? ::setenv("HOME", home->c_str(), 1) : ::unsetenv("HOME");
  }

 private:
  std::optional<std::string> before_;
};

TEST_F(MapFolder, MayLieInTheHome) {
  set_home("/home/robot");
  EXPECT_EQ(folder_of("~/maps"), "/home/robot/maps");
  EXPECT_EQ(folder_of("~"), "/home/robot/");
  EXPECT_EQ(folder_of("~maps"), "~maps");
  EXPECT_EQ(folder_of("/srv/maps"), "/srv/maps");
}

TEST_F(MapFolder, IsNotGuessedWhereThereIsNoHome) {
  set_home(std::nullopt);
  EXPECT_THROW(folder_of("~/maps"), std::runtime_error);
  set_home("");
  EXPECT_THROW(folder_of("~/maps"), std::runtime_error);
  EXPECT_EQ(folder_of("/srv/maps"), "/srv/maps");
}

}  // namespace
}  // namespace portolan
