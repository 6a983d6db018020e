// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/map_picture.hpp"

#include <yaml-cpp/yaml.h>

#include <cctype>
#include <cmath>
#include <stdexcept>

#include "portolan/options/value.hpp"

namespace portolan {

namespace {

using options_detail::format_double;

constexpr std::int64_t kMaxSide = 1000000;  // [cell]

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
  if (std::abs(cells) > static_cast<double>(kMaxSide)) fail(file, "origin is too far away");
  if (std::abs(cells - whole) > 1e-3) fail(file, "origin must be a corner of a cell");
  return static_cast<std::int32_t>(whole);
}

// Reads the header of a binary PGM; comments run from # to the end of their line.
class PgmHeader {
 public:
  PgmHeader(const std::string& pgm, const std::string& file) : pgm_(pgm), file_(file) {
    if (pgm.compare(0, 2, "P5") != 0) fail(file, "not a binary PGM (P5)");
    width = read("width", kMaxSide);
    height = read("height", kMaxSide);
    if (read("largest value", 65535) != 255) fail(file, "the largest value must be 255");
    ++at_;  // one white space, then the pixels
    const auto pixels = static_cast<std::int64_t>(pgm.size()) - static_cast<std::int64_t>(at_);
    if (pixels != width * height) fail(file, "its size does not fit its header");
  }

  std::int64_t width = 0;
  std::int64_t height = 0;
  const char* pixels() const { return pgm_.data() + at_; }

 private:
  std::int64_t read(const char* what, std::int64_t largest) {
    skip_space();
    std::int64_t value = 0;
    for (; at_ < pgm_.size() && std::isdigit(static_cast<unsigned char>(pgm_[at_])); ++at_) {
      value = 10 * value + (pgm_[at_] - '0');
      if (value > largest) fail(file_, std::string(what) + " is too large");
    }
    if (value == 0) fail(file_, std::string(what) + " is missing or 0");
    return value;
  }

  void skip_space() {
    for (; at_ < pgm_.size(); ++at_) {
      if (pgm_[at_] == '#') at_ = std::min(pgm_.find('\n', at_), pgm_.size() - 1);
      if (!std::isspace(static_cast<unsigned char>(pgm_[at_]))) return;
    }
  }

  const std::string& pgm_;
  const std::string& file_;
  std::size_t at_ = 2;
};

void read_keys(const YAML::Node& keys, const std::string& file, MapPicture& picture) {
  if (keys["version"] && number(keys["version"], "version", file) != 1.0) {
    fail(file, "version must be 1");
  }
  picture.resolution = number(keys["resolution"], "resolution", file);
  if (picture.resolution <= 0.0) fail(file, "resolution must be above 0");
  picture.occupied_thresh = number(keys["occupied_thresh"], "occupied_thresh", file);
  picture.free_thresh = number(keys["free_thresh"], "free_thresh", file);
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
  std::string pgm = "P5\n" + std::to_string(picture.rect.width()) + " " +
                    std::to_string(picture.rect.height()) + "\n255\n";
  for (int y = picture.rect.height() - 1; y >= 0; --y) {
    const auto first =
        picture.pixels.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y) * width);
    pgm.append(first, first + static_cast<std::ptrdiff_t>(width));
  }
  return pgm;
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
  const bool is_bare = image.find('/') == std::string::npos && !image.empty() && image[0] != '.';
  if (!is_bare) fail(file, "image must be the bare name of a file beside it");
  return image;
}

MapPicture read_map_picture(const std::string& yaml, const std::string& file,
                            const std::string& pgm, const std::string& image) {
  MapPicture picture;
  const YAML::Node keys = parse(yaml, file);
  read_keys(keys, file, picture);
  const bool negate = keys["negate"].IsDefined() && number(keys["negate"], "negate", file) != 0.0;
  const PgmHeader header(pgm, image);
  const auto width = static_cast<std::size_t>(header.width);
  const auto height = static_cast<std::size_t>(header.height);
  picture.rect.max = {picture.rect.min.x + static_cast<std::int32_t>(width),
                      picture.rect.min.y + static_cast<std::int32_t>(height)};
  picture.pixels.reserve(width * height);
  for (std::size_t row = height; row-- > 0;) {
    const char* first = header.pixels() + row * width;
    picture.pixels.insert(picture.pixels.end(), first, first + width);
  }
  if (negate) {
    for (std::uint8_t& pixel : picture.pixels) pixel = static_cast<std::uint8_t>(255 - pixel);
  }
  return picture;
}

}  // namespace portolan
