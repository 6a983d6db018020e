// SPDX-License-Identifier: BSD-3-Clause
// Grid maps: map.yaml, map.pgm and the laser layer's pair.
#include "fuzz.hpp"
#include "portolan/grid/map_files.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace portolan;
  const std::vector<std::string> parts = fuzz::split(data, size);
  FileSet files;
  std::size_t i = 0;
  for (const char* name : {"map.yaml", "map.pgm", "map_laser.yaml", "map_laser.pgm"}) {
    if (i < parts.size()) files[name] = parts[i++];
  }
  const GridMapper::Options options;
  fuzz::load_and_save(
      files, [&](const FileSet& set) { return read_map_files(set, "map", options); },
      [](const GridMapper& map) {
        return map.layers().empty() ? FileSet{} : map_files(map, PixelMode::scale);
      });
  return 0;
}
