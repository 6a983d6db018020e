// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/map_files.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "portolan/grid/pgm.hpp"
#include "portolan/options/value.hpp"

namespace portolan {

namespace {

constexpr double kOccupiedThreshold = 0.65;
constexpr double kFreeThreshold = 0.196;
constexpr std::uint8_t kOccupied = 0;
constexpr std::uint8_t kFree = 254;
constexpr std::uint8_t kUnknown = 205;
constexpr std::size_t kMostBytes = std::size_t{1} << 28;  // a picture of 16,384 x 16,384 pixels

using Probability = std::optional<double>;

/// What the YAML beside a picture says of it.
struct Legend {
  std::string image;
  Cell origin;  // the lower left one
  bool negate = false;
  double occupied_threshold = kOccupiedThreshold;
  double free_threshold = kFreeThreshold;
  GridFileMode mode = GridFileMode::trinary;
  std::vector<GridLayer> layers;
};

std::string layer_name(GridLayer layer) {
  return enum_names(layer).at(static_cast<std::size_t>(layer));
}

std::uint8_t trinary_pixel(double p) {
  if (p > kOccupiedThreshold) return kOccupied;
  return p < kFreeThreshold ? kFree : kUnknown;
}

/// The pixel for unknown is not taken by a probability.
std::uint8_t scale_pixel(double p) {
  const auto pixel = static_cast<std::uint8_t>(std::lround(255.0 * (1.0 - p)));
  if (pixel != kUnknown) return pixel;
  return 255.0 * (1.0 - p) > kUnknown ? kUnknown + 1 : kUnknown - 1;
}

std::uint8_t pixel_of(const Probability& p, GridFileMode mode) {
  if (!p) return kUnknown;
  return mode == GridFileMode::trinary ? trinary_pixel(*p) : scale_pixel(*p);
}

/// map_server's rule; scale keeps what lies beyond the thresholds too.
Probability probability_of(std::uint8_t pixel, const Legend& legend) {
  const double p = legend.negate ? pixel / 255.0 : (255 - pixel) / 255.0;
  if (legend.mode == GridFileMode::scale) return pixel == kUnknown ? Probability{} : p;
  const bool known = p > legend.occupied_threshold || p < legend.free_threshold;
  return known ? Probability{p} : Probability{};
}

template <class ProbabilityOf>
GreyPicture drawn(const CellRect& rect, GridFileMode mode, ProbabilityOf probability) {
  GreyPicture picture{
      static_cast<std::size_t>(rect.width()), static_cast<std::size_t>(rect.height()), {}};
  picture.pixels.reserve(picture.width * picture.height);
  for (int y = rect.max.y - 1; y >= rect.min.y; --y) {
    for (int x = rect.min.x; x < rect.max.x; ++x) {
      picture.pixels.push_back(pixel_of(probability(Cell{x, y}), mode));
    }
  }
  return picture;
}

std::string yaml_of(const std::string& name, Cell origin, double resolution, GridFileMode mode,
                    const std::vector<GridLayer>& layers) {
  using options_detail::format_double;
  std::string yaml = "image: " + name + ".pgm\n" + "resolution: " + format_double(resolution) +
                     "\n" + "origin: [" + format_double(origin.x * resolution) + ", " +
                     format_double(origin.y * resolution) + ", 0]\n" +
                     "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n" +
                     "mode: " + options_detail::format(mode) + "\n";
  if (layers.empty()) return yaml;
  std::string names;
  for (const GridLayer layer : layers) names += (names.empty() ? "" : ", ") + layer_name(layer);
  return yaml + "layers: [" + names + "]\n";
}

GridCells cells_of(GreyPicture picture, const Legend& legend) {
  const Cell min = legend.origin;
  const Cell max{min.x + static_cast<int>(picture.width), min.y + static_cast<int>(picture.height)};
  return {{min, max}, [picture = std::move(picture), legend, min, max](Cell cell) {
            const auto row = static_cast<std::size_t>(max.y - 1 - cell.y);
            const auto column = static_cast<std::size_t>(cell.x - min.x);
            return probability_of(picture.pixels[row * picture.width + column], legend);
          }};
}

double number(const YAML::Node& yaml, const char* key, const Interval& allowed) {
  if (!yaml[key]) throw std::runtime_error(std::string("it lacks the key ") + key);
  const double value = options_detail::parse_double(yaml[key].as<std::string>());
  if (!allowed.contains(value)) {
    throw std::runtime_error(std::string(key) + " must be " + allowed.words());
  }
  return value;
}

Cell origin_cell(const YAML::Node& origin, double resolution) {
  if (!origin || !origin.IsSequence() || origin.size() < 2) {
    throw std::runtime_error("origin must be [x, y, yaw]");
  }
  const auto coordinate = [&](std::size_t i) {
    const double cells = origin[i].as<double>() / resolution;
    if (!(std::abs(cells) < 1e9)) throw std::runtime_error("origin lies out of the world");
    return static_cast<int>(std::lround(cells));
  };
  const double yaw = origin.size() > 2 ? origin[2].as<double>() : 0.0;
  if (yaw != 0.0) throw std::runtime_error("origin is turned; only yaw 0 can be mapped on");
  return {coordinate(0), coordinate(1)};
}

std::string bare_image(const YAML::Node& yaml) {
  if (!yaml["image"]) throw std::runtime_error("it lacks the key image");
  return yaml["image"].as<std::string>();
}

Legend parse_legend(const YAML::Node& yaml, const GridMapper::Options& options) {
  if (!yaml.IsMap()) throw std::runtime_error("it is no map of keys");
  const double resolution = number(yaml, "resolution", above(0.0));
  if (std::abs(resolution / options.resolution - 1.0) > 1e-6) {
    throw std::runtime_error("its resolution is " + options_detail::format_double(resolution) +
                             ", but the parameter resolution is " +
                             options_detail::format_double(options.resolution));
  }
  Legend legend;
  legend.image = bare_image(yaml);
  legend.origin = origin_cell(yaml["origin"], resolution);
  if (yaml["negate"]) legend.negate = number(yaml, "negate", within(0.0, 1.0)) != 0.0;
  legend.occupied_threshold = number(yaml, "occupied_thresh", within(0.0, 1.0));
  legend.free_threshold = number(yaml, "free_thresh", within(0.0, 1.0));
  using options_detail::parse;
  if (yaml["mode"]) legend.mode = parse<GridFileMode>(yaml["mode"].as<std::string>());
  if (!yaml["layers"]) return legend;
  for (const auto& name : yaml["layers"]) {
    legend.layers.push_back(parse<GridLayer>(name.as<std::string>()));
  }
  return legend;
}

/// Runs a step of loading; what it throws is told with the file that it is about.
template <class Step>
auto about(const std::filesystem::path& file, Step step) {
  try {
    return step();
  } catch (const std::exception& error) {
    throw std::runtime_error(file.string() + ": " + error.what());
  }
}

Legend read_legend(const std::filesystem::path& folder, const std::string& file,
                   const std::string& text, const GridMapper::Options& options) {
  return about(folder / file, [&] { return parse_legend(YAML::Load(text), options); });
}

GridCells read_cells(const std::filesystem::path& folder, const Legend& legend,
                     const FileSet& files) {
  return about(folder / legend.image,
               [&] { return cells_of(from_pgm(files.at(legend.image)), legend); });
}

std::vector<std::string> yaml_names(const std::string& name, const std::vector<GridLayer>& layers) {
  std::vector<std::string> names;
  for (const GridLayer layer : layers) names.push_back(name + "_" + layer_name(layer) + ".yaml");
  return names;
}

using Legends = std::map<std::string, Legend>;  // by YAML file

/// Which files the map consists of, as far as the YAML in `files` tells.
Legends read_legends(const std::filesystem::path& folder, const std::string& main,
                     const std::vector<std::string>& layer_yamls, const FileSet& files,
                     const GridMapper::Options& options) {
  Legends legends;
  legends[main] = read_legend(folder, main, files.at(main), options);
  for (const std::string& yaml : layer_yamls) {
    legends[yaml] = read_legend(folder, yaml, files.at(yaml), options);
  }
  return legends;
}

bool agree(const FileSet& before, const FileSet& now) {
  return std::all_of(before.begin(), before.end(),
                     [&](const auto& file) { return now.at(file.first) == file.second; });
}

}  // namespace

FileSet grid_files(const GridMapper& map, const std::string& name, GridFileMode mode) {
  if (map.bounds().empty()) throw std::runtime_error("the map is empty: there is nothing to save");
  FileSet files;
  LayerCells as_loaded;
  const double resolution = map.options().resolution;
  const auto add = [&](const std::string& file, const CellRect& rect, const GreyPicture& picture,
                       const std::vector<GridLayer>& layers) {
    files[file + ".pgm"] = to_pgm(picture);
    files[file + ".yaml"] = yaml_of(file, rect.min, resolution, mode, layers);
  };
  for (const GridLayer layer : map.layers()) {
    const CellRect rect = map.bounds(layer);
    const GreyPicture picture =
        drawn(rect, mode, [&](Cell cell) { return map.probability(layer, cell); });
    add(name + "_" + layer_name(layer), rect, picture, {});
    Legend legend;
    legend.origin = rect.min;
    legend.mode = mode;
    as_loaded.emplace(layer, cells_of(picture, legend));
  }
  const GridMapper loaded(map.options(), as_loaded);
  const CellRect rect = map.bounds();
  add(name, rect, drawn(rect, mode, [&](Cell cell) { return loaded.probability(cell); }),
      map.layers());
  return files;
}

GridMapper load_grid(const std::filesystem::path& folder, const std::string& name,
                     const GridMapper::Options& options) {
  const std::string main = name + ".yaml";
  std::vector<std::string> names = {main};
  FileSet files = load_files(folder, names, kMostBytes);
  const Legend fused = read_legend(folder, main, files.at(main), options);
  const std::vector<std::string> layer_yamls = yaml_names(name, fused.layers);
  names.insert(names.end(), layer_yamls.begin(), layer_yamls.end());
  files = load_files(folder, names, kMostBytes);
  const Legends legends = read_legends(folder, main, layer_yamls, files, options);
  for (const auto& [yaml, legend] : legends) names.push_back(legend.image);
  const FileSet all = load_files(folder, names, kMostBytes);
  if (!agree(files, all)) return load_grid(folder, name, options);  // saved anew meanwhile
  LayerCells layers;
  if (layer_yamls.empty()) layers.emplace(GridLayer::laser, read_cells(folder, fused, all));
  for (std::size_t i = 0; i < layer_yamls.size(); ++i) {
    layers.emplace(fused.layers[i], read_cells(folder, legends.at(layer_yamls[i]), all));
  }
  return GridMapper(options, layers);
}

}  // namespace portolan
