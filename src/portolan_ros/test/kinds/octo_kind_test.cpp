// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/kinds/octo_kind.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "octo_maps.hpp"
#include "portolan_ros/kinds/octo_picture.hpp"

namespace portolan {
namespace {

class OctoKindTest : public testing::Test {
 protected:
  OctoKindTest() {
    std::string name = (std::filesystem::temp_directory_path() / "octo_kind_XXXXXX").string();
    folder = mkdtemp(name.data());
    options.mapper = octo_options();
    options.node.map_frame = "world";
  }
  ~OctoKindTest() override { std::filesystem::remove_all(folder); }

  void save(const FileSet& files) const { save_files(folder, files); }
  OctoMapper load() const { return OctoKind::load(folder, "map", options); }

  std::filesystem::path folder;
  MapperNodeOptions<OctoKind> options;
};

TEST_F(OctoKindTest, LoadsWhatItSaved) {
  const FileSet files = OctoKind::save(octo_map(1), "map", options);
  EXPECT_EQ(files.size(), 3u);
  EXPECT_NE(files.at("map.yaml").find("map_frame: world"), std::string::npos);
  save(files);
  EXPECT_EQ(OctoKind::save(load(), "map", options), files);
}

TEST_F(OctoKindTest, LoadsATreeThatAnotherProgramWrote) {
  const FileSet files = OctoKind::save(octo_map(1), "map", options);
  save({{"map.bt", files.at("map.bt")}});  // neither log-odds nor YAML
  EXPECT_EQ(OctoKind::save(load(), "map", options).at("map.bt"), files.at("map.bt"));
}

TEST_F(OctoKindTest, RefusesAnotherResolutionUnlessItMayResample) {
  save(OctoKind::save(octo_map(1), "map", options));
  options.mapper.resolution = 0.2;
  EXPECT_THROW(load(), std::runtime_error);
  options.output.files.other_resolution = OtherResolution::resample;
  EXPECT_EQ(load().options().resolution, 0.2);
  EXPECT_GT(load().blocks().size(), 10u);
}

TEST_F(OctoKindTest, SaysWhichFileIsMissing) {
  try {
    load();
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("map.bt"), std::string::npos) << error.what();
  }
}

TEST_F(OctoKindTest, KeepsItsFilesApartFromThoseOfOtherMaps) {
  EXPECT_EQ(options.node.map_name, "octomap");
  EXPECT_EQ(faults(options).size(), 0u);
}

TEST_F(OctoKindTest, CountsWhatBecameOfThePoints) {
  OctoMapper map(octo_options());
  PointCloud cloud;
  cloud.points = {{1.0F, 0.0F, 0.0F}, {1e6F, 0.0F, 0.0F}};
  map.insert(cloud, Pose::Identity());
  EXPECT_EQ(OctoKind::counts(map).at("points that hit"), 1u);
  EXPECT_EQ(OctoKind::counts(map).at("points outside of the octree"), 1u);
}

TEST_F(OctoKindTest, DrawsNothingOfNothing) {
  EXPECT_TRUE(OctoKind::pictures(OctoMapper(octo_options()), "map", {}).empty());
}

TEST(OctoPicture, ShowsTheMapFromAboveAndFromTheSide) {
  OctoMapper map(octo_options());
  PointCloud cloud;
  for (int i = 0; i < 8; ++i) {
    cloud.points.emplace_back(0.45F, 0.05F, 0.05F + 0.1F * static_cast<float>(i));
  }
  map.insert(cloud, Pose(Eigen::Translation3d(0.05, 0.05, 0.0)));
  const Picture picture = octo_picture(map, {});
  EXPECT_EQ(picture.width() % 8, 0u);
  EXPECT_EQ(picture.height(), picture.width() * 18 / 8);  // two views of 8 rows, 2 between them
  EXPECT_NE(picture.png(),
            octo_picture(map, {planar_pose(0.0, 0.0, 0.0), planar_pose(0.5, 0.5, 0.0)}).png());
}

TEST(OctoPicture, OfFarPlacesStaysSmallEnough) {
  OctoMapper map(octo_options());
  PointCloud cloud;
  cloud.points = {{3000.0F, 0.0F, 0.0F}, {-3000.0F, 10.0F, 0.0F}};
  map.insert(cloud, Pose::Identity());
  const Picture picture = octo_picture(map, {});
  EXPECT_LE(picture.width(), 4000u);
  EXPECT_GE(picture.width(), 2000u);
}

}  // namespace
}  // namespace portolan
