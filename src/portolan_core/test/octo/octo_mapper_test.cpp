// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/octo_mapper.hpp"

#include <gtest/gtest.h>

#include "octo/octo_fixture.hpp"

namespace portolan::octo_test {
namespace {

OctoMapper::Options random_options(Random& random) {
  OctoMapper::Options options;
  options.resolution = std::array{0.05, 0.1, 0.1, 0.25, 0.37}[random() % 5];
  options.sensor_model.hit = uniform(random, 0.51, 0.95);
  options.sensor_model.miss = uniform(random, 0.05, 0.49);
  options.sensor_model.min = uniform(random, 0.05, 0.4);
  options.sensor_model.max = uniform(random, 0.6, 0.99);
  options.sensor_model.max_range = random() % 3 == 0 ? -1.0 : uniform(random, 0.5, 6.0);
  options.discretize = random() % 3 == 0;
  return options;
}

TEST(OctoMapper, makes_the_same_tree_as_the_library) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    Random random(seed);
    const OctoMapper::Options options = random_options(random);
    OctoMapper map(options);
    OctreeMirror mirror(options);
    octomap::OcTree expected = empty_tree(options);
    for (int i = 0; i < 12; ++i) {
      const Pose T_map_sensor = random_pose(random, i % 4 == 0 ? 0.0 : 1.5);
      const PointCloud cloud = random_cloud(random, 150, 5.0, options.resolution);
      ASSERT_EQ(map.insert(cloud, T_map_sensor), Outcome::inserted);
      insert(expected, options, cloud, T_map_sensor);
      if (i % 3 == 0) mirror.follow(map, 0);
    }
    mirror.follow(map, 0);
    ASSERT_GT(expected.size(), 100U);
    ASSERT_EQ(bytes(octree(map)), bytes(expected)) << "seed " << seed;
    ASSERT_EQ(bytes(mirror.tree()), bytes(expected)) << "seed " << seed;
    ASSERT_EQ(mirror.tree().size(), expected.calcNumNodes());
    ASSERT_TRUE(mirror.tree() == octree(map));
  }
}

}  // namespace
}  // namespace portolan::octo_test
