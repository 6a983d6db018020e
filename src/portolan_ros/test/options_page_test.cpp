// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/options_page.hpp"

#include <gtest/gtest.h>

#include <string>

#include "portolan_ros/kinds/for_each_kind.hpp"
#include "portolan_ros/mapper_node_options.hpp"

namespace portolan {
namespace {

TEST(OptionsPage, ConfigurationFilesReadBackToTheDefaults) {
  for_each_kind([](auto kind) {
    using Kind = decltype(kind);
    const MapperNodeOptions<Kind> defaults;
    const std::string file = config_file(Kind::kName, option_rows(defaults));
    MapperNodeOptions<Kind> read;
    ASSERT_NO_THROW(read_options(YAML::Load(file)[Kind::kName], read)) << file;
    EXPECT_EQ(to_yaml(option_rows(read)), to_yaml(option_rows(defaults)));
  });
}

TEST(OptionsPage, NamesEveryOptionInItsTable) {
  const std::string page = page_section("node", {{"a/b", "number", "1", "above 0", "it [m]"}});
  EXPECT_NE(page.find("## node"), std::string::npos);
  EXPECT_NE(page.find("`a/b`"), std::string::npos);
  EXPECT_NE(page.find("above 0"), std::string::npos);
}

TEST(OptionsPage, SaysWhereItCanNotWrite) {
  EXPECT_THROW(document("/proc/no/folder", "node", {}), std::runtime_error);
}

}  // namespace
}  // namespace portolan
