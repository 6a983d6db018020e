// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/map_files.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "portolan/grid/fuse.hpp"
#include "portolan/grid/map_picture.hpp"
#include "portolan/options/value.hpp"

namespace portolan {

namespace {

constexpr std::size_t kLayers = kGridLayers.size();
constexpr std::size_t kMaxBytes = 1U << 30;

std::string name_of(const std::string& name, GridLayer layer) {
  return name + "_" + enum_names(layer)[static_cast<std::size_t>(layer)];
}

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// The line of the fused map's YAML that names its layers: beside it may lie those of an older map.
std::string layers_line(const std::vector<GridLayer>& layers) {
  std::string line;
  for (GridLayer layer : layers) {
    line += (line.empty() ? "layers: [" : ", ") +
            std::string(enum_names(layer)[static_cast<std::size_t>(layer)]);
  }
  return line + "]\n";
}

// The layers that a well-formed YAML names; none where it is not ours.
std::set<GridLayer> layers_in(const std::string& yaml, const std::string& file) try {
  std::set<GridLayer> layers;
  const YAML::Node named = YAML::Load(yaml)["layers"];
  if (!named.IsDefined()) return layers;
  for (const auto& name : named.as<std::vector<std::string>>()) {
    layers.insert(options_detail::parse<GridLayer>(name));
  }
  return layers;
} catch (const YAML::Exception&) {
  throw std::runtime_error(file + ": layers must be a list of names");
} catch (const std::invalid_argument& expected) {
  throw std::runtime_error(file + ": a layer must be " + expected.what());
}

std::uint8_t pixel_of(double p, const MapPicture& picture) {
  if (picture.mode == "trinary") {
    if (p > picture.occupied_thresh) return MapPicture::kOccupied;
    return p < picture.free_thresh ? MapPicture::kFree : MapPicture::kUnknown;
  }
  const auto pixel = static_cast<std::uint8_t>(std::lround(255.0 * (1.0 - p)));
  return pixel == MapPicture::kUnknown ? MapPicture::kUnknown - 1 : pixel;
}

// The pixel of every byte.
std::array<std::uint8_t, 256> pixels_of(const LogOdds& log_odds, const MapPicture& picture) {
  std::array<std::uint8_t, 256> pixels;
  pixels[kNeverObserved] = MapPicture::kUnknown;
  for (std::size_t cell = 1; cell < 256; ++cell) {
    pixels[cell] = pixel_of(log_odds.probability(static_cast<CellByte>(cell)), picture);
  }
  return pixels;
}

void add(FileSet& files, const std::string& name, const GridMapper& map, PixelMode mode,
         const CellRect& rect, const std::vector<CellByte>& cells) {
  MapPicture picture;
  picture.rect = rect;
  picture.resolution = map.options().resolution;
  picture.mode = enum_names(mode)[static_cast<std::size_t>(mode)];
  const std::array<std::uint8_t, 256> pixel = pixels_of(map.log_odds(), picture);
  for (CellByte cell : cells) picture.pixels.push_back(pixel[cell]);
  files[name + ".yaml"] = to_map_yaml(picture, name + ".pgm");
  files[name + ".pgm"] = to_pgm(picture);
}

const std::string& file_in(const FileSet& files, const std::string& name) {
  const auto found = files.find(name);
  if (found == files.end()) throw std::runtime_error(name + ": no such file");
  return found->second;
}

MapPicture picture_in(const FileSet& files, const std::string& name,
                      const GridMapper::Options& options) {
  const std::string file = name + ".yaml";
  const std::string& yaml = file_in(files, file);
  const std::string image = image_of(yaml, file);
  MapPicture picture = read_map_picture(yaml, file, file_in(files, image), image);
  if (std::abs(picture.resolution - options.resolution) > 1e-9 * options.resolution) {
    throw std::runtime_error(file + ": its resolution is " + std::to_string(picture.resolution) +
                             " m, but the map's is " + std::to_string(options.resolution) + " m");
  }
  return picture;
}

// Finds bytes of the layers that give the pixels of the layers and of the fused map: pixels keep
// less than bytes do, so of those that are possible the first one is taken, certain ones first.
class Solver {
 public:
  // One pixel for the fused map and each layer; kAbsent where a layer has none there.
  using Pixels = std::array<int, kLayers + 1>;
  static constexpr int kAbsent = -1;
  struct Solution {
    CellStack stack{};
    CellByte latest = 0;
  };

  Solver(const GridMapper::Options& options, const MapPicture& picture)
      : fusion_(options.fusion),
        log_odds_(options),
        picture_(picture),
        pixel_(pixels_of(log_odds_, picture)) {}

  const Solution& solve(const Pixels& pixels) {
    const auto [entry, is_new] = known_.try_emplace(pixels);
    if (is_new) entry->second = search(pixels);
    return entry->second;
  }

  // The bytes that have this pixel, likely ones first.
  std::vector<CellByte> candidates(int pixel) const {
    if (pixel == kAbsent) return {kNeverObserved};
    const auto wanted = static_cast<std::uint8_t>(pixel);
    std::vector<CellByte> found;
    if (wanted == MapPicture::kUnknown) found = {kNeverObserved, log_odds_.prior()};
    for (int cell = log_odds_.min(); cell <= log_odds_.max(); ++cell) {
      if (pixel_[static_cast<std::size_t>(cell)] == wanted)
        found.push_back(static_cast<CellByte>(cell));
    }
    if (found.empty()) found = {nearest(wanted)};
    if (wanted < MapPicture::kUnknown) std::reverse(found.begin(), found.end());
    return found;
  }

 private:
  // For pictures of other origin, whose pixels ours never have.
  CellByte nearest(std::uint8_t pixel) const {
    const double p = picture_.probability(pixel);
    if (picture_.mode == "scale") return log_odds_.byte(p);
    if (p > picture_.occupied_thresh) return log_odds_.max();
    return p < picture_.free_thresh ? log_odds_.min() : kNeverObserved;
  }

  Solution search(const Pixels& pixels) const {
    std::array<std::vector<CellByte>, kLayers> choices;
    for (std::size_t i = 0; i < kLayers; ++i) choices[i] = candidates(pixels[i + 1]);
    for (CellByte a : choices[0]) {
      for (CellByte b : choices[1]) {
        for (CellByte c : choices[2]) {
          const std::optional<Solution> found = fit({a, b, c}, pixels[0]);
          if (found) return *found;
        }
      }
    }
    return {{choices[0][0], choices[1][0], choices[2][0]}, 0};
  }

  std::optional<Solution> fit(const CellStack& stack, int fused) const {
    for (std::size_t latest = 0; latest <= kLayers; ++latest) {
      if (latest > 0 && stack[latest - 1] == kNeverObserved) continue;
      const auto last = static_cast<CellByte>(latest);
      if (pixel_[fuse(fusion_, log_odds_, stack, last)] == fused) return Solution{stack, last};
      if (fusion_ != Fusion::latest) break;
    }
    return std::nullopt;
  }

  Fusion fusion_;
  LogOdds log_odds_;
  MapPicture picture_;
  std::array<std::uint8_t, 256> pixel_;
  std::map<Pixels, Solution> known_;
};

int pixel_at(const MapPicture& picture, Cell cell) {
  if (!picture.rect.contains(cell)) return Solver::kAbsent;
  const auto width = static_cast<std::size_t>(picture.rect.width());
  return picture.pixels[static_cast<std::size_t>(cell.y - picture.rect.min.y) * width +
                        static_cast<std::size_t>(cell.x - picture.rect.min.x)];
}

GridMapper::KeptLayer laser_layer(const MapPicture& picture, const GridMapper::Options& options) {
  const Solver solver(options, picture);
  std::array<CellByte, 256> byte;
  for (std::size_t i = 0; i < 256; ++i) byte[i] = solver.candidates(static_cast<int>(i)).front();
  GridMapper::KeptLayer kept{GridLayer::laser, picture.rect, {}, {}};
  for (std::uint8_t pixel : picture.pixels) kept.cells.push_back(byte[pixel]);
  return kept;
}

using Layers = std::map<GridLayer, MapPicture>;

GridMapper::KeptLayer kept_layer(GridLayer layer, const Layers& layers, const MapPicture& fused,
                                 Solver& solver) {
  const CellRect& rect = layers.at(layer).rect;
  const auto i = static_cast<std::size_t>(layer);
  GridMapper::KeptLayer kept{layer, rect, {}, {}};
  for (Cell cell = rect.min; cell.y < rect.max.y; ++cell.y) {
    for (cell.x = rect.min.x; cell.x < rect.max.x; ++cell.x) {
      Solver::Pixels pixels{pixel_at(fused, cell), Solver::kAbsent, Solver::kAbsent,
                            Solver::kAbsent};
      for (const auto& [other, picture] : layers) {
        pixels[static_cast<std::size_t>(other) + 1] = pixel_at(picture, cell);
      }
      const Solver::Solution& solution = solver.solve(pixels);
      kept.cells.push_back(solution.stack[i]);
      kept.is_latest.push_back(solution.latest == i + 1);
    }
  }
  return kept;
}

}  // namespace

FileSet map_files(const GridMapper& map, PixelMode mode, const std::string& name) {
  FileSet files;
  if (map.bounds().empty()) throw std::runtime_error("nothing has been observed yet");
  add(files, name, map, mode, map.bounds(), map.cells(map.bounds()));
  files[name + ".yaml"] += layers_line(map.layers());
  for (GridLayer layer : map.layers()) {
    const CellRect rect = map.bounds(layer);
    add(files, name_of(name, layer), map, mode, rect, map.cells(layer, rect));
  }
  return files;
}

GridMapper read_map_files(const FileSet& files, const std::string& name,
                          const GridMapper::Options& options) {
  checked(options);
  const MapPicture fused = picture_in(files, name, options);
  Layers layers;
  const std::string head = name + ".yaml";
  for (GridLayer layer : layers_in(file_in(files, head), head)) {
    layers[layer] = picture_in(files, name_of(name, layer), options);
  }
  if (layers.empty()) return GridMapper(options, {laser_layer(fused, options)});
  Solver solver(options, fused);
  std::vector<GridMapper::KeptLayer> kept;
  for (const auto& entry : layers) kept.push_back(kept_layer(entry.first, layers, fused, solver));
  return GridMapper(options, kept);
}

GridMapper load_map(const std::filesystem::path& folder, const std::string& name,
                    const GridMapper::Options& options) {
  const std::string head = name + ".yaml";
  const auto more = [&](const FileSet& found) {
    std::vector<std::string> names;
    for (GridLayer layer : layers_in(found.at(head), head)) {
      names.push_back(name_of(name, layer) + ".yaml");
    }
    for (const auto& [file, content] : found) {
      if (ends_with(file, ".yaml")) names.push_back(image_of(content, file));
    }
    return names;
  };
  return read_map_files(load_files(folder, {head}, kMaxBytes, more), name, options);
}

}  // namespace portolan
