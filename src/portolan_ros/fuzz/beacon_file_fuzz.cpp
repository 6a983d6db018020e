// SPDX-License-Identifier: BSD-3-Clause
// beacons.yaml
#include "fuzz.hpp"
#include "portolan/beacon/beacon_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace portolan;
  const BeaconOptions options;
  fuzz::load_and_save(
      {{"beacons.yaml", {data, data + size}}},
      [&](const FileSet& set) { return beacons_from_yaml(set.at("beacons.yaml"), options); },
      [](const BeaconMapper& map) {
        return FileSet{{"beacons.yaml", to_yaml(map)}};
      });
  return 0;
}
