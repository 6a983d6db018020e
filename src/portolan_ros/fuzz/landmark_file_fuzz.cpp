// SPDX-License-Identifier: BSD-3-Clause
// landmarks.yaml
#include "fuzz.hpp"
#include "portolan/landmark/landmark_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace portolan;
  const LandmarkOptions options;
  fuzz::load_and_save(
      {{"landmarks.yaml", {data, data + size}}},
      [&](const FileSet& set) { return landmarks_from_yaml(set.at("landmarks.yaml"), options); },
      [](const LandmarkMapper& map) {
        return FileSet{{"landmarks.yaml", to_yaml(map)}};
      });
  return 0;
}
