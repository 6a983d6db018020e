// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/world_file.hpp"

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "portolan/grid/map_picture.hpp"
#include "portolan/grid/pgm.hpp"

namespace portolan::sim {

namespace {

Pgm read_image(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error(path + ": cannot be opened");
  return read_pgm({std::istreambuf_iterator<char>(in), {}}, path);
}

/// What map_server makes of a gray value: p = (255 - v) / 255, or v / 255 where negated.
bool is_occupied(std::uint8_t gray, bool negate, double threshold) {
  const double bright = gray / 255.0;
  return (negate ? bright : 1.0 - bright) > threshold;
}

/// One block for each run of occupied cells in a row.
void add_row(const std::vector<bool>& occupied, double left, double y, double side, double height,
             std::vector<WorldOptions::Box>& boxes) {
  for (std::size_t i = 0; i < occupied.size(); ++i) {
    const std::size_t begin = i;
    while (i < occupied.size() && occupied[i]) ++i;
    if (i == begin) continue;
    const double length = static_cast<double>(i - begin) * side;
    WorldOptions::Box box;
    box.center = {left + static_cast<double>(begin) * side + 0.5 * length, y};
    box.size = {length, side};
    box.height = height;
    boxes.push_back(box);
  }
}

WorldOptions from_map(const YAML::Node& yaml, const std::string& image_path, double wall_height) {
  const Pgm image = read_image(image_path);
  const auto side = yaml["resolution"].as<double>();
  const auto origin = yaml["origin"].as<std::vector<double>>();
  const bool negate = yaml["negate"].as<int>(0) != 0;
  const auto threshold = yaml["occupied_thresh"].as<double>(MapPicture::kOccupiedThresh);
  if (!(side > 0.0) || origin.size() != 3) throw std::runtime_error("bad resolution or origin");
  if (origin[2] != 0.0) throw std::runtime_error("a map that is turned cannot be a world");
  WorldOptions world;
  for (std::size_t row = 0; row < image.height; ++row) {
    std::vector<bool> occupied(image.width);
    for (std::size_t i = 0; i < image.width; ++i) {
      occupied[i] = is_occupied(image.pixels[row * image.width + i], negate, threshold);
    }
    const double y = origin[1] + (static_cast<double>(image.height - row) - 0.5) * side;
    add_row(occupied, origin[0], y, side, wall_height, world.boxes);
  }
  return world;
}

std::string beside(const std::string& path, const std::string& name) {
  const std::size_t slash = path.rfind('/');
  const bool alone = slash == std::string::npos || (!name.empty() && name[0] == '/');
  return alone ? name : path.substr(0, slash + 1) + name;
}

WorldOptions from_yaml(const std::string& path, double wall_height) {
  const YAML::Node yaml = YAML::LoadFile(path);
  if (yaml.IsMap() && yaml["image"]) {
    return from_map(yaml, beside(path, yaml["image"].as<std::string>()), wall_height);
  }
  WorldOptions world;
  read_options(yaml, world);
  return world;
}

}  // namespace

WorldOptions read_world(const std::string& path, double wall_height) try {
  return from_yaml(path, wall_height);
} catch (const std::exception& error) {
  throw std::runtime_error("world " + path + ": " + error.what());
}

}  // namespace portolan::sim
