// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/octo_files.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "octo/octo_fixture.hpp"

namespace portolan::octo_test {
namespace {

OctoMapper::Options options(double resolution) {
  OctoMapper::Options options;
  options.resolution = resolution;
  options.sensor_model.max_range = 4.0;
  return options;
}

OctoMapper some_map(unsigned seed, double resolution = 0.1) {
  Random random(seed);
  OctoMapper map(options(resolution));
  for (int i = 0; i < 6; ++i) {
    map.insert(random_cloud(random, 120, 2.0, resolution), random_pose(random, 0.5));
  }
  return map;
}

std::string fault_of(const FileSet& files, const OctoFileOptions& how = {}) {
  try {
    read_octo_files(files, "map", options(0.1), how);
  } catch (const std::runtime_error& fault) {
    return fault.what();
  }
  return "no fault";
}

bool says(const std::string& fault, const std::string& part) {
  return fault.find(part) != std::string::npos;
}

TEST(OctoFiles, save_load_save_gives_equal_files) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const OctoMapper map = some_map(seed);
    const FileSet files = map_files(map, "map", "map");
    const OctoMapper loaded = read_octo_files(files, "map", map.options());
    EXPECT_EQ(map_files(loaded, "map", "map"), files);
    EXPECT_EQ(count_of_known(loaded), count_of_known(map));
    EXPECT_GT(loaded.revision(), 0U);
  }
}

TEST(OctoFiles, are_read_by_the_library) {
  const OctoMapper map = some_map(1);
  const FileSet files = map_files(map, "map", "map");
  std::istringstream full(files.at("map.ot"));
  const std::unique_ptr<octomap::AbstractOcTree> read(octomap::AbstractOcTree::read(full));
  ASSERT_NE(read, nullptr);
  EXPECT_EQ(bytes(dynamic_cast<octomap::OcTree&>(*read)), bytes(octree(map)));
  std::istringstream binary(files.at("map.bt"));
  octomap::OcTree tree(0.1);
  ASSERT_TRUE(tree.readBinary(binary));
  EXPECT_GT(tree.size(), 100U);
}

TEST(OctoFiles, with_a_binary_tree_alone_say_free_or_occupied) {
  const OctoMapper map = some_map(2);
  FileSet files = map_files(map, "map", "map");
  files.erase("map.ot");
  const OctoMapper loaded = read_octo_files(files, "map", map.options());
  EXPECT_EQ(count_of_known(loaded), count_of_known(map));
  map.blocks().for_each([&](BlockKey key, const VoxelBlock& block) {
    const VoxelBlock* other = loaded.blocks().find(key);
    ASSERT_NE(other, nullptr);
    EXPECT_EQ(occupied(block, 0.0F), occupied(*other, 0.0F));
    EXPECT_EQ(block.known, other->known);
  });
}

TEST(OctoFiles, do_not_change_the_configured_sensor_model) {
  const FileSet files = map_files(some_map(3), "map", "map");
  OctoMapper::Options mine = options(0.1);
  mine.sensor_model.hit = 0.9;
  mine.sensor_model.max = 0.8;
  OctoMapper loaded = read_octo_files(files, "map", mine);
  EXPECT_EQ(loaded.options().sensor_model.hit, 0.9);
  PointCloud cloud;
  cloud.points = {{50.05F, 1.05F, 0.05F}};
  loaded.insert(cloud, Pose(Eigen::Translation3d(0.05, 0.05, 0.05)) *
                           Pose(Eigen::Translation3d(49.0, 0.0, 0.0)));
  EXPECT_EQ(loaded.log_odds({99.1F, 1.1F, 0.1F}), std::nullopt);
  cloud.points = {{1.0F, 0.0F, 0.0F}};
  loaded.insert(cloud, Pose(Eigen::Translation3d(49.05, 0.05, 0.05)));
  EXPECT_EQ(loaded.log_odds({50.05F, 0.05F, 0.05F}), octomap::logodds(0.8));
}

TEST(OctoFiles, go_on_like_the_map_that_was_saved) {
  OctoMapper map = some_map(4);
  OctoMapper loaded = read_octo_files(map_files(map, "map", "map"), "map", map.options());
  Random random(9);
  const PointCloud more = random_cloud(random, 200, 2.0, 0.1);
  map.insert(more, Pose::Identity());
  loaded.insert(more, Pose::Identity());
  EXPECT_EQ(bytes(octree(loaded)), bytes(octree(map)));
}

TEST(OctoFiles, of_another_resolution_are_refused_or_resampled) {
  const OctoMapper fine = some_map(5, 0.05);
  const FileSet files = map_files(fine, "map", "map");
  EXPECT_TRUE(says(fault_of(files), "0.05 m are not the map's of 0.1 m"));
  OctoFileOptions how;
  how.other_resolution = OtherResolution::resample;
  const OctoMapper coarse = read_octo_files(files, "map", options(0.1), how);
  coarse.blocks().for_each([&](BlockKey key, const VoxelBlock& block) {
    for (std::size_t i = 0; i < 512; ++i) {
      if (!block.is_known(i)) continue;
      const auto place = static_cast<int>(i);
      float most = -std::numeric_limits<float>::infinity();
      for (int part = 0; part < 8; ++part) {
        const auto at = [&](int k, int bit) {
          return static_cast<float>(coarse.lattice().centre(k) + ((part & bit) ? 0.025 : -0.025));
        };
        const auto log_odds =
            fine.log_odds({at(8 * key.x + place % 8, 1), at(8 * key.y + place / 8 % 8, 2),
                           at(8 * key.z + place / 64, 4)});
        if (log_odds) most = std::max(most, *log_odds);
      }
      ASSERT_EQ(block.log_odds[i], most);
    }
  });
  const OctoMapper finer =
      read_octo_files(map_files(some_map(5, 0.2), "map", "map"), "map", options(0.1), how);
  EXPECT_EQ(count_of_known(finer), 8 * count_of_known(some_map(5, 0.2)));
}

TEST(OctoFiles, of_nothing_hold_nothing) {
  const FileSet files = map_files(OctoMapper(options(0.1)), "map", "map");
  EXPECT_EQ(read_octo_files(files, "map", options(0.1)).blocks().size(), 0U);
}

TEST(OctoFiles, that_are_broken_are_refused_by_name_and_reason) {
  const FileSet good = map_files(some_map(6), "map", "map");
  const auto with = [&](const std::string& content) {
    FileSet files = good;
    files["map.ot"] = content;
    return files;
  };
  const std::string tree = good.at("map.ot");
  EXPECT_EQ(fault_of(good), "no fault");
  EXPECT_TRUE(says(fault_of({}), "neither map.ot nor map.bt"));
  EXPECT_TRUE(says(fault_of(with("")), "map.ot: its header is cut off"));
  EXPECT_TRUE(says(fault_of(with("P5\n3 3\n255\n")), "no octree file"));
  EXPECT_TRUE(says(fault_of(with(tree.substr(0, tree.size() - 1))), "cut off"));
  EXPECT_TRUE(says(fault_of(with(tree + "x")), "goes on after its last node"));
  std::string other = tree;
  EXPECT_TRUE(says(fault_of(with(other.replace(other.find("id OcTree"), 9, "id ColorO"))),
                   "tree of type ColorO"));
  other = tree;
  EXPECT_TRUE(says(fault_of(with(other.replace(other.find("res 0.1"), 7, "res nan"))), "res"));
  other = tree;
  EXPECT_TRUE(says(fault_of(with(other.insert(other.find("size ") + 5, "1"))), "nodes and holds"));
  FileSet yaml = good;
  yaml["map.yaml"] = "format: something else\n";
  EXPECT_TRUE(says(fault_of(yaml), "map.yaml: its format"));
  yaml["map.yaml"] = "{[";
  EXPECT_TRUE(says(fault_of(yaml), "map.yaml: "));
}

TEST(OctoFiles, that_claim_the_whole_world_are_refused) {
  std::string file = "# Octomap OcTree file\nid OcTree\nsize 1\nres 0.1\ndata\n";
  file += std::string("\0\0\x80\x3f\0", 5);  // the root a leaf: 2^48 voxels
  EXPECT_TRUE(says(fault_of({{"map.ot", file}}), "more memory than max_memory"));
  OctoFileOptions how;
  how.max_memory = 0.01;
  EXPECT_TRUE(says(fault_of(map_files(some_map(7), "map", "map"), how), "more memory"));
}

TEST(OctoFiles, that_are_rubbish_never_crash) {
  const FileSet good = map_files(some_map(8), "map", "map");
  Random random(1);
  OctoFileOptions how;
  how.max_memory = 20.0;
  std::size_t refused = 0;
  for (int i = 0; i < 400; ++i) {
    FileSet files = good;
    if (i % 2 == 0) files.erase("map.ot");
    std::string& content = files.begin()->second;
    for (int k = 0; k < 1 + i % 5; ++k) {
      content[random() % content.size()] = static_cast<char>(random());
    }
    if (i % 3 == 0) content.resize(random() % content.size());
    refused += fault_of(files, how) == "no fault" ? 0 : 1;
  }
  EXPECT_GT(refused, 150U);
}

}  // namespace
}  // namespace portolan::octo_test
