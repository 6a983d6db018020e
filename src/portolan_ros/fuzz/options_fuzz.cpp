// SPDX-License-Identifier: BSD-3-Clause
// A node's parameters as YAML.
#include <yaml-cpp/yaml.h>

#include "fuzz.hpp"
#include "portolan/beacon/beacon_options.hpp"
#include "portolan/grid/grid_options.hpp"
#include "portolan/octo/octo_mapper.hpp"
#include "portolan/options.hpp"
#include "portolan/remapper_options.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace portolan;
  const auto read = [&](auto options) {
    try {
      RemapperOptions remapper;
      read_options(YAML::Load(std::string(data, data + size)), options, remapper);
    } catch (const std::exception&) {
    }
  };
  read(GridOptions{});
  read(OctoMapper::Options{});
  read(BeaconOptions{});
  return 0;
}
