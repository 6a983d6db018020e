// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/octo_files.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "portolan/octo/octree_mirror.hpp"
#include "portolan/octo/octree_reader.hpp"

namespace portolan {

namespace {

constexpr int kVoxels = BlockKey::kVoxels;
constexpr VoxelBlocks::Revision kLoaded = 1;
constexpr const char* kFormat = "portolan octomap 1";

std::string yaml_of(const OctoMapper::Options& options, const std::string& map_frame) {
  return std::string("format: ") + kFormat +
         "\nmap_frame: " + options_detail::format_string(map_frame) + "\n" +
         to_yaml(option_rows(options));
}

void check_yaml(const std::string& text, const OctreeHeader& header) {
  const YAML::Node yaml = YAML::Load(text);
  const auto text_of = [&](const char* key) {
    return yaml.IsMap() && yaml[key].IsDefined() && yaml[key].IsScalar() ? yaml[key].Scalar() : "";
  };
  if (text_of("format") != kFormat)
    throw std::runtime_error("its format is not " + std::string(kFormat));
  const double resolution = options_detail::parse_double(text_of("resolution"));
  if (!(std::abs(resolution - header.resolution) <= 1e-5 * resolution)) {
    throw std::runtime_error("its resolution is not that of the octree beside it");
  }
}

/// Voxels that come from a file, no more of them than fit in the memory that they may take.
class Loaded {
 public:
  explicit Loaded(double max_memory)
      : max_blocks_(1e6 * max_memory / static_cast<double>(sizeof(VoxelBlock))) {}

  /// Sets all voxels of a leaf.
  void fill(const OctreeLeaf& leaf) {
    const int side = 1 << leaf.level;
    const int blocks = std::max(1, side / kVoxels);
    reserve(std::pow(static_cast<double>(blocks), 3.0));
    for (int z = 0; z < blocks; ++z) {
      for (int y = 0; y < blocks; ++y) {
        for (int x = 0; x < blocks; ++x) {
          const auto at = [&](unsigned axis, int i) {
            return static_cast<octomap::key_type>(leaf.corner[axis] + kVoxels * i);
          };
          fill_in_block({at(0, x), at(1, y), at(2, z)}, std::min(side, kVoxels), leaf.log_odds);
        }
      }
    }
  }

  /// Makes a voxel at least so likely to be occupied.
  void raise(const octomap::OcTreeKey& key, float log_odds) {
    reserve(1.0);
    VoxelBlock& block = blocks_.change(block_of(key), kLoaded);
    const std::size_t i = VoxelBlock::index(key[0] % 8, key[1] % 8, key[2] % 8);
    block.log_odds[i] = block.is_known(i) ? std::max(block.log_odds[i], log_odds) : log_odds;
    block.known[i / 64] |= std::uint64_t{1} << (i % 64);
  }

  const VoxelBlocks& blocks() const { return blocks_; }

 private:
  void reserve(double more) const {
    if (static_cast<double>(blocks_.size()) + more > max_blocks_) {
      throw std::runtime_error("it needs more memory than max_memory allows");
    }
  }

  void fill_in_block(const octomap::OcTreeKey& corner, int side, float log_odds) {
    VoxelBlock& block = blocks_.change(block_of(corner), kLoaded);
    for (int z = 0; z < side; ++z) {
      for (int y = 0; y < side; ++y) {
        const std::size_t row =
            VoxelBlock::index(corner[0] % 8, corner[1] % 8 + y, corner[2] % 8 + z);
        std::fill_n(&block.log_odds[row], side, log_odds);
        block.known[row / 64] |= ((std::uint64_t{1} << side) - 1) << (row % 64);
      }
    }
  }

  double max_blocks_;
  VoxelBlocks blocks_;
};

/// Calls visit(key) for each voxel of a lattice whose centre lies between two coordinates on each
/// axis, and for the one that holds their middle.
template <class Visit>
void for_each_voxel(const VoxelLattice& lattice, const Eigen::Vector3d& low,
                    const Eigen::Vector3d& high, Visit visit) {
  const double side = lattice.resolution();
  const auto bound = [](double cell) {
    return static_cast<int>(std::clamp<double>(cell, 0, VoxelLattice::kSide));
  };
  const auto first = [&](int i) {
    return bound(std::ceil(low[i] / side - 0.5) + VoxelLattice::kMiddle);
  };
  const auto last = [&](int i) {
    return bound(std::ceil(high[i] / side - 0.5) + VoxelLattice::kMiddle);
  };
  const Eigen::Vector3f middle = (0.5 * (low + high)).cast<float>();
  if (const auto key = lattice.key({middle.x(), middle.y(), middle.z()})) visit(*key);
  for (int x = first(0); x < last(0); ++x) {
    for (int y = first(1); y < last(1); ++y) {
      for (int z = first(2); z < last(2); ++z) {
        visit(octomap::OcTreeKey(static_cast<octomap::key_type>(x),
                                 static_cast<octomap::key_type>(y),
                                 static_cast<octomap::key_type>(z)));
      }
    }
  }
}

Loaded resampled(const Loaded& loaded, const VoxelLattice& from, const VoxelLattice& to,
                 double max_memory) {
  Loaded result(max_memory);
  const double half = 0.5 * from.resolution();
  loaded.blocks().for_each([&](BlockKey key, const VoxelBlock& block) {
    for (std::size_t i = 0; i < block.log_odds.size(); ++i) {
      if (!block.is_known(i)) continue;
      const auto place = static_cast<int>(i);
      const Eigen::Vector3d centre(from.centre(8 * key.x + place % 8),
                                   from.centre(8 * key.y + place / 8 % 8),
                                   from.centre(8 * key.z + place / 64));
      for_each_voxel(
          to, centre.array() - half, centre.array() + half,
          [&](const octomap::OcTreeKey& voxel) { result.raise(voxel, block.log_odds[i]); });
    }
  });
  return result;
}

OctoMapper read_file(const std::string& file, const OctreeHeader& header,
                     const OctoMapper::Options& options, const OctoFileOptions& how) {
  const bool is_same =
      std::abs(header.resolution - options.resolution) <= 1e-5 * options.resolution;
  if (!is_same && how.other_resolution == OtherResolution::refuse) {
    throw std::runtime_error("its voxels of " + options_detail::format_double(header.resolution) +
                             " m are not the map's of " +
                             options_detail::format_double(options.resolution) + " m");
  }
  const LogOddsModel model(options.sensor_model);
  Loaded loaded(how.max_memory);
  read_octree(file, header, model.min, model.max,
              [&](const OctreeLeaf& leaf) { loaded.fill(leaf); });
  if (!is_same) {
    loaded = resampled(loaded, VoxelLattice(header.resolution), VoxelLattice(options.resolution),
                       how.max_memory);
  }
  return OctoMapper(options, loaded.blocks());
}

/// What octomap's readers expect before the nodes; its writers would also talk to the console.
std::string header_of(const octomap::OcTree& tree, const std::string& first_line) {
  return first_line + "\nid OcTree\nsize " + std::to_string(tree.size()) + "\nres " +
         options_detail::format_double(tree.getResolution()) + "\ndata\n";
}

/// Does the work and puts the file's name before what goes wrong.
template <class Work>
auto naming(const std::string& file, Work work) {
  try {
    return work();
  } catch (const std::exception& fault) {
    throw std::runtime_error(file + ": " + fault.what());
  }
}

}  // namespace

FileSet map_files(const OctoMapper& map, const std::string& name, const std::string& map_frame) {
  octomap::OcTree tree = octree(map);
  std::ostringstream full(header_of(tree, "# Octomap OcTree file"), std::ios::ate);
  tree.writeData(full);
  tree.toMaxLikelihood();
  tree.prune();
  std::ostringstream binary(header_of(tree, "# Octomap OcTree binary file"), std::ios::ate);
  tree.writeBinaryData(binary);
  return {{name + ".ot", full.str()},
          {name + ".bt", binary.str()},
          {name + ".yaml", yaml_of(map.options(), map_frame)}};
}

OctoMapper read_octo_files(const FileSet& files, const std::string& name,
                           const OctoMapper::Options& options, const OctoFileOptions& how) {
  auto tree = files.find(name + ".ot");
  if (tree == files.end()) tree = files.find(name + ".bt");
  if (tree == files.end()) throw std::runtime_error("neither " + name + ".ot nor " + name + ".bt");
  const auto& [file, content] = *tree;
  const OctreeHeader header =
      naming(file, [&content = content] { return read_octree_header(content); });
  const auto yaml = files.find(name + ".yaml");
  if (yaml != files.end()) naming(yaml->first, [&] { check_yaml(yaml->second, header); });
  return naming(file, [&, &content = content] { return read_file(content, header, options, how); });
}

}  // namespace portolan
