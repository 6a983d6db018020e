// SPDX-License-Identifier: BSD-3-Clause
// Octrees: map.ot, map.bt and map.yaml.
#include "fuzz.hpp"
#include "portolan/octo/octo_files.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace portolan;
  const std::vector<std::string> parts = fuzz::split(data, size);
  FileSet files;
  std::size_t i = 0;
  for (const char* name : {"map.ot", "map.bt", "map.yaml"}) {
    if (i < parts.size() && !parts[i].empty()) files[name] = parts[i];
    ++i;
  }
  const OctoMapper::Options options;
  OctoFileOptions how;
  how.max_memory = 20.0;
  how.other_resolution = size % 2 == 0 ? OtherResolution::refuse : OtherResolution::resample;
  fuzz::load_and_save(
      files, [&](const FileSet& set) { return read_octo_files(set, "map", options, how); },
      [](const OctoMapper& map) { return map_files(map, "map", "map"); });
  return 0;
}
