// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/kinds/grid_kind.hpp"

#include <algorithm>
#include <stdexcept>

#include "portolan_ros/picture.hpp"

namespace portolan {

namespace {

using ros_convert::GridSheet;

constexpr Picture::Colour kUnknown{205, 205, 205};
constexpr Picture::Colour kWay{38, 110, 200};

std::string layer_name(GridLayer layer) {
  return enum_names(layer).at(static_cast<std::size_t>(layer));
}

Picture::Colour shade(std::int8_t percent) {
  if (percent < 0) return kUnknown;
  const auto grey = static_cast<std::uint8_t>(254 - percent * 254 / 100);
  return {grey, grey, grey};
}

/// A picture of the cells, enlarged so that small maps can be looked at too.
Picture drawn(const GridMapper& map, GridSheet sheet, const CellRect& rect) {
  const auto width = static_cast<std::size_t>(rect.width());
  const auto height = static_cast<std::size_t>(rect.height());
  Picture picture(width, height, kUnknown);
  const std::vector<std::int8_t> cells = sheet ? map.occupancy(*sheet, rect) : map.occupancy(rect);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    picture.set(static_cast<std::int64_t>(i % width),
                static_cast<std::int64_t>(height - 1 - i / width), shade(cells[i]));
  }
  constexpr std::size_t kGoodSide = 1000;  // [pixel]
  return picture.enlarged(std::max<std::size_t>(1, kGoodSide / std::max(width, height)));
}

void draw_way(Picture& picture, const CellRect& rect, double resolution,
              const std::vector<Pose>& T_map_base) {
  const double pixels_per_cell = static_cast<double>(picture.width()) / rect.width();
  const auto column = [&](const Pose& pose) {
    return (pose.translation().x() / resolution - rect.min.x) * pixels_per_cell;
  };
  const auto row = [&](const Pose& pose) {
    return (rect.max.y - pose.translation().y() / resolution) * pixels_per_cell;
  };
  for (std::size_t i = 1; i < T_map_base.size(); ++i) {
    const Pose& a = T_map_base[i - 1];
    const Pose& b = T_map_base[i];
    picture.line(column(a), row(a), column(b), row(b), kWay);
  }
}

std::string picture_of(const GridMapper& map, GridSheet sheet,
                       const std::vector<Pose>& T_map_base) {
  const CellRect rect = sheet ? map.bounds(*sheet) : map.bounds();
  Picture picture = drawn(map, sheet, rect);
  draw_way(picture, rect, map.options().resolution, T_map_base);
  return picture.png();
}

}  // namespace

FileSet GridKind::save(const GridMapper& map, const std::string& name,
                       const MapperNodeOptions<GridKind>& options) {
  const CellRect rect = map.bounds();
  if (rect.empty()) return {};
  if (static_cast<double>(rect.width()) * rect.height() > options.output.max_cells) {
    throw std::runtime_error("the map is too large to save; see max_cells");
  }
  return map_files(map, options.output.file_mode, name);
}

GridMapper GridKind::load(const std::filesystem::path& folder, const std::string& name,
                          const MapperNodeOptions<GridKind>& options) {
  return load_map(folder, name, options.mapper);
}

FileSet GridKind::pictures(const GridMapper& map, const std::string& name,
                           const std::vector<Pose>& T_map_base) {
  FileSet files;
  if (map.bounds().empty()) return files;
  files[name + ".png"] = picture_of(map, std::nullopt, T_map_base);
  for (const GridLayer layer : map.layers()) {
    files[name + "_" + layer_name(layer) + ".png"] = picture_of(map, layer, T_map_base);
  }
  return files;
}

}  // namespace portolan
