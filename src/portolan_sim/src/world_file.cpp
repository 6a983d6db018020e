// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/world_file.hpp"

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>

namespace portolan::sim {

namespace {

struct Image {
  std::size_t width = 0;
  std::size_t height = 0;
  int white = 255;
  std::string pixels;  // row by row from the top
};

/// The next word of a PGM header; comments run from # to the end of the line.
std::string next_word(std::istream& in) {
  std::string word;
  while (in >> word && word[0] == '#') in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  return word;
}

Image read_pgm(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot be opened");
  if (next_word(in) != "P5") throw std::runtime_error("is no binary PGM (P5)");
  Image image;
  image.width = std::stoul(next_word(in));
  image.height = std::stoul(next_word(in));
  image.white = std::stoi(next_word(in));
  in.get();  // the one blank that ends the header
  if (image.white < 1 || image.white > 255)
    throw std::runtime_error("has more than 8 bits a pixel");
  image.pixels.assign(std::istreambuf_iterator<char>(in), {});
  if (image.width == 0 || image.pixels.size() / image.width < image.height) {
    throw std::runtime_error("holds fewer pixels than it says");
  }
  return image;
}

/// What map_server makes of a gray value: p = (255 - v) / 255, or v / 255 where negated.
bool is_occupied(std::uint8_t gray, int white, bool negate, double threshold) {
  const double bright = static_cast<double>(gray) / white;
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
  const Image image = read_pgm(image_path);
  const auto side = yaml["resolution"].as<double>();
  const auto origin = yaml["origin"].as<std::vector<double>>();
  const bool negate = yaml["negate"].as<int>(0) != 0;
  const auto threshold = yaml["occupied_thresh"].as<double>(0.65);
  if (!(side > 0.0) || origin.size() != 3) throw std::runtime_error("bad resolution or origin");
  if (origin[2] != 0.0) throw std::runtime_error("a map that is turned cannot be a world");
  WorldOptions world;
  for (std::size_t row = 0; row < image.height; ++row) {
    std::vector<bool> occupied(image.width);
    for (std::size_t i = 0; i < image.width; ++i) {
      const auto gray = static_cast<std::uint8_t>(image.pixels[row * image.width + i]);
      occupied[i] = is_occupied(gray, image.white, negate, threshold);
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
