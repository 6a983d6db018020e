// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

#include "portolan/map_file.hpp"
#include "portolan/octo/octo_mapper.hpp"

namespace portolan {

/// What to do with a map file whose voxels have another size than the map's.
enum class OtherResolution {
  refuse,
  resample,  ///< each voxel takes the most occupied of what overlaps it, centre in the other
};

constexpr std::array<const char*, 2> enum_names(OtherResolution) { return {"refuse", "resample"}; }

/// How octree files are read.
struct OctoFileOptions {
  OtherResolution other_resolution = OtherResolution::refuse;
  double max_memory = 2000.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("other_resolution", self.other_resolution,
          "a map file with voxels of another size than the map's");
    visit("max_memory", self.max_memory, "a map file that needs more is refused [MB]", above(0.0));
  }
};

/// The map as files: `<name>.ot` with all log-odds, `<name>.bt` with free and occupied only, both
/// as octomap's own programs read them, and `<name>.yaml` with what these do not say: the frame,
/// the sensor model and the thresholds.
FileSet map_files(const OctoMapper& map, const std::string& name, const std::string& map_frame);

/// A map with these options and the voxels of `<name>.ot`, or else of `<name>.bt`. Sensor model and
/// thresholds are those of the options, whatever the files say. Throws std::runtime_error that
/// names file and fault: none of both files, not an octree, cut off, bytes left over, another
/// resolution, more memory needed than allowed, YAML of another format.
OctoMapper read_octo_files(const FileSet& files, const std::string& name,
                           const OctoMapper::Options& options, const OctoFileOptions& how = {});

}  // namespace portolan
