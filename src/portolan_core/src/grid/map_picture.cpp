// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/map_picture.hpp"

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <stdexcept>

#include "portolan/grid/pgm.hpp"
#include "portolan/map_file.hpp"
#include "portolan/options/value.hpp"

namespace portolan {

namespace {

using options_detail::format_double;

constexpr double kMaxCell = 1e6;  // of the origin

[[noreturn]] void fail(const std::string& file, const std::string& reason) {
  throw std::runtime_error(file + ": " + reason);
}

YAML::Node parse(const std::string& yaml, const std::string& file) try {
  YAML::Node node = YAML::Load(yaml);
  if (!node.IsMap()) fail(file, "not a map of keys");
  return node;
} catch (const YAML::Exception& error) {
  fail(file, error.what());
}

double number(const YAML::Node& node, const std::string& key, const std::string& file) try {
  if (!node.IsDefined()) fail(file, key + " is missing");
  const double value = options_detail::parse_double(node.Scalar());
  if (!std::isfinite(value)) fail(file, key + " must be finite");
  return value;
} catch (const std::invalid_argument&) {
  fail(file, key + " must be a number");
}

// The index of the cell whose lower corner lies at `metres`.
std::int32_t corner(double metres, double resolution, const std::string& file) {
  const double cells = metres / resolution;
  const double whole = std::round(cells);
  if (std::abs(cells) > kMaxCell) fail(file, "origin is too far away");
  if (std::abs(cells - whole) > 1e-3) fail(file, "origin must be a corner of a cell");
  return static_cast<std::int32_t>(whole);
}

// The rows in the opposite order: pictures have the highest y first, maps the lowest.
std::vector<std::uint8_t> upside_down(const std::vector<std::uint8_t>& pixels, std::size_t width) {
  std::vector<std::uint8_t> turned;
  turned.reserve(pixels.size());
  for (auto end = pixels.end(); end != pixels.begin();) {
    const auto first = end - static_cast<std::ptrdiff_t>(width);
    turned.insert(turned.end(), first, end);
    end = first;
  }
  return turned;
}

void read_keys(const YAML::Node& keys, const std::string& file, MapPicture& picture) {
  if (keys["version"] && number(keys["version"], "version", file) != 1.0) {
    fail(file, "version must be 1");
  }
  picture.resolution = number(keys["resolution"], "resolution", file);
  if (picture.resolution <= 0.0) fail(file, "resolution must be above 0");
  picture.occupied_thresh = number(keys["occupied_thresh"], "occupied_thresh", file);
  picture.free_thresh = number(keys["free_thresh"], "free_thresh", file);
  if (picture.free_thresh < 0.0 || picture.occupied_thresh > 1.0 ||
      picture.free_thresh > picture.occupied_thresh) {
    fail(file, "0 <= free_thresh <= occupied_thresh <= 1 must hold");
  }
  if (keys["mode"]) picture.mode = keys["mode"].as<std::string>("");
  if (picture.mode != "trinary" && picture.mode != "scale") {
    fail(file, "mode must be trinary or scale");
  }
  const YAML::Node origin = keys["origin"];
  if (!origin.IsDefined() || !origin.IsSequence() || origin.size() != 3)
    fail(file, "origin must be [x, y, yaw]");
  if (number(origin[2], "origin's yaw", file) != 0.0) fail(file, "origin's yaw must be 0");
  picture.rect.min = {corner(number(origin[0], "origin's x", file), picture.resolution, file),
                      corner(number(origin[1], "origin's y", file), picture.resolution, file)};
}

}  // namespace

double MapPicture::probability(std::uint8_t pixel) const { return (255 - pixel) / 255.0; }

std::string to_pgm(const MapPicture& picture) {
  const auto width = static_cast<std::size_t>(picture.rect.width());
  const auto height = static_cast<std::size_t>(picture.rect.height());
  return to_bytes(Pgm{width, height, upside_down(picture.pixels, width)});
}

std::string to_map_yaml(const MapPicture& picture, const std::string& image) {
  const auto metres = [&](std::int32_t cell) { return format_double(cell * picture.resolution); };
  return "version: 1\nimage: " + image + "\nmode: " + picture.mode +
         "\nresolution: " + format_double(picture.resolution) + "\norigin: [" +
         metres(picture.rect.min.x) + ", " + metres(picture.rect.min.y) +
         ", 0]\nnegate: 0\noccupied_thresh: " + format_double(picture.occupied_thresh) +
         "\nfree_thresh: " + format_double(picture.free_thresh) + "\n";
}

std::string image_of(const std::string& yaml, const std::string& file) {
  const YAML::Node keys = parse(yaml, file);
  const YAML::Node named = keys["image"];
  const std::string image = named.IsDefined() && named.IsScalar() ? named.Scalar() : "";
  if (!is_bare_name(image)) fail(file, "image must be the bare name of a file beside it");
  return image;
}

MapPicture read_map_picture(const std::string& yaml, const std::string& file,
                            const std::string& pgm, const std::string& image) {
  MapPicture picture;
  const YAML::Node keys = parse(yaml, file);
  read_keys(keys, file, picture);
  const bool negate = keys["negate"].IsDefined() && number(keys["negate"], "negate", file) != 0.0;
  const Pgm read = read_pgm(pgm, image);
  picture.rect.max = {picture.rect.min.x + static_cast<std::int32_t>(read.width),
                      picture.rect.min.y + static_cast<std::int32_t>(read.height)};
  picture.pixels = upside_down(read.pixels, read.width);
  if (negate) {
    for (std::uint8_t& pixel : picture.pixels) pixel = static_cast<std::uint8_t>(255 - pixel);
  }
  return picture;
}

}  // namespace portolan
