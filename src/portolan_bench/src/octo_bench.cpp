// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>
#include <octomap/OcTree.h>

#include <array>
#include <functional>
#include <sstream>
#include <string>

#include "octo_workload.hpp"
#include "pairs.hpp"
#include "portolan/octo/cloud_filter.hpp"
#include "portolan/octo/octo_mapper.hpp"
#include "portolan/octo/octree_mirror.hpp"
#include "portolan/remapper.hpp"

namespace portolan::bench {
namespace {

constexpr int kClouds = 20;
constexpr int kCloudsPerSecond = 10;

OctoMapper::Options our_options(const OctoScene& scene) {
  OctoMapper::Options options;
  options.resolution = scene.resolution;
  options.sensor_model.max_range = scene.max_range;
  return options;
}

octomap::OcTree empty_tree(const OctoScene& scene) {
  octomap::OcTree tree(scene.resolution);
  configure(tree, SensorModel{});
  return tree;
}

octomap::Pointcloud in_map(const PosedCloud& view) {
  octomap::Pointcloud points;
  points.reserve(view.cloud.points.size());
  for (const Eigen::Vector3f& p : view.cloud.points) points.push_back(to_map(view.T_map_sensor, p));
  return points;
}

/// What octomap_server does with a cloud: sets of free and occupied keys, a node at a time, and the
/// tree pruned.
class ServerLoop {
 public:
  explicit ServerLoop(const OctoScene& scene)
      : tree_(empty_tree(scene)), max_range_(scene.max_range) {}

  void insert(const PosedCloud& view) {
    const octomap::point3d origin = to_map(view.T_map_sensor, Eigen::Vector3f::Zero());
    octomap::KeySet free;
    octomap::KeySet occupied;
    for (const Eigen::Vector3f& p : view.cloud.points) {
      add(origin, to_map(view.T_map_sensor, p), free, occupied);
    }
    for (const auto& key : free) {
      if (occupied.find(key) == occupied.end()) tree_.updateNode(key, false);
    }
    for (const auto& key : occupied) tree_.updateNode(key, true);
    tree_.prune();
  }

  const octomap::OcTree& tree() const { return tree_; }

 private:
  void add(const octomap::point3d& origin, octomap::point3d p, octomap::KeySet& free,
           octomap::KeySet& occupied) {
    const bool hit = max_range_ < 0.0 || (p - origin).norm() <= max_range_;
    if (!hit) p = origin + (p - origin).normalized() * static_cast<float>(max_range_);
    if (tree_.computeRayKeys(origin, p, ray_)) free.insert(ray_.begin(), ray_.end());
    octomap::OcTreeKey key;
    if (hit && tree_.coordToKeyChecked(p, key)) occupied.insert(key);
  }

  octomap::OcTree tree_;
  octomap::KeyRay ray_;
  double max_range_;
};

std::string bytes(const octomap::OcTree& tree) {
  std::ostringstream out;
  tree.writeData(out);
  return out.str();
}

/// octomap::OcTree::insertPointCloud.
class Library {
 public:
  explicit Library(const OctoScene& scene)
      : tree_(empty_tree(scene)), max_range_(scene.max_range) {}

  void insert(const PosedCloud& view) {
    tree_.insertPointCloud(in_map(view), to_map(view.T_map_sensor, Eigen::Vector3f::Zero()),
                           max_range_);
  }

  const octomap::OcTree& tree() const { return tree_; }

 private:
  octomap::OcTree tree_;
  double max_range_;
};

double seconds_of(const std::function<void()>& work) {
  Pairs alone;
  return alone.run([] {}, work);
}

/// A new map each; cloud by cloud in turn, and of ours an octree once a second. An error where the
/// trees differ in the end.
template <class Peer>
void insert_clouds(benchmark::State& state, const OctoScene& scene) {
  Peer peer(scene);
  OctoMapper ours(our_options(scene));
  OctreeMirror mirror(ours.options());
  Pairs pairs;
  double tree = 0.0;
  int i = 0;
  for (auto _ : state) {
    const PosedCloud view = octo_cloud(scene, i++);
    state.SetIterationTime(
        pairs.run([&] { peer.insert(view); }, [&] { ours.insert(view.cloud, view.T_map_sensor); }));
    if (i % kCloudsPerSecond == 0) tree += seconds_of([&] { mirror.follow(ours, 0); });
  }
  if (bytes(mirror.tree()) != bytes(peer.tree())) state.SkipWithError("the trees differ");
  const double with_tree = pairs.ours() + tree / kClouds;
  state.counters["ms_peer"] = 1e3 * pairs.peer();
  state.counters["ms_ours"] = 1e3 * pairs.ours();
  state.counters["ms_with_tree"] = 1e3 * with_tree;
  state.counters["times_faster"] = pairs.ratio();
  state.counters["times_with_tree"] = pairs.ratio() * pairs.ours() / with_tree;
}

/// Kilometres of street: what a cloud costs in each quarter of the way, alone and with an octree
/// that follows once a second, until it has followed for a quarter.
void drive(benchmark::State& state, const OctoScene& scene) {
  OctoMapper map(our_options(scene));
  OctreeMirror mirror(map.options());
  std::array<Pairs, 4> quarters;
  double tree_seconds = 0.0;
  const auto clouds = static_cast<int>(state.max_iterations);
  int i = 0;
  for (auto _ : state) {
    const PosedCloud view = street_cloud(scene, i);
    Pairs& quarter = quarters[static_cast<std::size_t>(4 * i / clouds)];
    state.SetIterationTime(quarter.run([] {}, [&] { map.insert(view.cloud, view.T_map_sensor); }));
    ++i;
    const bool is_followed = 4 * i <= clouds && i % kCloudsPerSecond == 0;
    if (is_followed) tree_seconds += seconds_of([&] { mirror.follow(map, 0); });
  }
  state.counters["km"] = 1e-3 * scene.spacing * clouds;
  for (std::size_t q = 0; q < quarters.size(); ++q) {
    state.counters["ms_quarter_" + std::to_string(q + 1)] = 1e3 * quarters[q].ours();
  }
  state.counters["ms_tree_per_cloud"] = 1e3 * tree_seconds / (0.25 * clouds);
  state.counters["MB_map"] = 1e-6 * static_cast<double>(byte_size(map));
}

/// Draws all clouds anew after a correction, as they are and thinned to a point a voxel.
void rebuild(benchmark::State& state, const OctoScene& scene, bool thins) {
  Remapper<OctoMapper> remapper({4000.0, {}}, our_options(scene));
  for (int i = 0; i < kClouds; ++i) {
    PosedCloud view = octo_cloud(scene, i);
    if (thins) view.cloud = thinned(std::move(view.cloud), scene.resolution, scene.max_range);
    remapper.observe(Time(seconds(i)), view.T_map_sensor, std::move(view.cloud));
  }
  double shift = 0.0;
  for (auto _ : state) {
    shift += 0.1;
    remapper.correct(Correction({{Time(seconds(0)), planar_pose(shift, 0.0, 0.01)}}));
    remapper.finish();
  }
  state.counters["MB_log_per_cloud"] = 1e-6 * static_cast<double>(remapper.log_bytes()) / kClouds;
  state.counters["clouds_per_s"] = benchmark::Counter(
      static_cast<double>(state.iterations()) * kClouds, benchmark::Counter::kIsRate);
}

const bool kRegistered = [] {
  static const std::vector<OctoScene> kScenes = octo_scenes();
  for (const OctoScene& scene : kScenes) {
    const auto add = [&scene](const std::string& row, auto run) {
      return benchmark::RegisterBenchmark((row + "/" + scene.name).c_str(), run);
    };
    using State = benchmark::State;
    add("octo_cloud/octomap", [&scene](State& state) { insert_clouds<Library>(state, scene); })
        ->UseManualTime()
        ->Iterations(kClouds);
    add("octo_cloud/server", [&scene](State& state) { insert_clouds<ServerLoop>(state, scene); })
        ->UseManualTime()
        ->Iterations(kClouds);
    for (const bool thins : {false, true}) {
      add(thins ? "octo_rebuild/thinned" : "octo_rebuild/whole",
          [&scene, thins](State& state) { rebuild(state, scene, thins); })
          ->Iterations(3)
          ->Unit(benchmark::kMillisecond);
    }
  }
  static const OctoScene kStreet = street_scene();
  benchmark::RegisterBenchmark(("octo_drive/" + kStreet.name).c_str(),
                               [](benchmark::State& state) { drive(state, kStreet); })
      ->UseManualTime()
      ->Iterations(2000);
  return true;
}();

}  // namespace
}  // namespace portolan::bench
