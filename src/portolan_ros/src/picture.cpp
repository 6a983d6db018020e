// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/picture.hpp"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace portolan {

namespace {

std::size_t area(std::size_t width, std::size_t height) {
  constexpr std::size_t kMost = std::size_t{1} << 28;
  if (width == 0 || height == 0 || width > kMost / height) {
    throw std::invalid_argument("a picture of " + std::to_string(width) + " x " +
                                std::to_string(height) + " pixels can't be made");
  }
  return width * height;
}

/// The part of a line that lies in the picture, by fractions of its length.
struct Part {
  double from = 0.0;
  double to = 1.0;

  double length() const { return to - from; }

  /// Cuts off where begin + fraction * way lies outside of [0, end].
  void cut(double begin, double way, double end) {
    if (way == 0.0) {
      if (begin < 0.0 || begin > end) to = -1.0;
      return;
    }
    const double at_0 = -begin / way;
    const double at_end = (end - begin) / way;
    from = std::max(from, std::min(at_0, at_end));
    to = std::min(to, std::max(at_0, at_end));
  }
};

}  // namespace

Picture::Picture(std::size_t width, std::size_t height, Colour background)
    : width_(width), pixels_(area(width, height), background) {}

void Picture::set(std::int64_t column, std::int64_t row, Colour colour) {
  const auto w = static_cast<std::int64_t>(width());
  const auto h = static_cast<std::int64_t>(height());
  if (column < 0 || row < 0 || column >= w || row >= h) return;
  pixels_[static_cast<std::size_t>(row * w + column)] = colour;
}

void Picture::mix(std::int64_t column, std::int64_t row, Colour colour, double opacity) {
  const auto w = static_cast<std::int64_t>(width());
  const auto h = static_cast<std::int64_t>(height());
  if (column < 0 || row < 0 || column >= w || row >= h) return;
  Colour& pixel = pixels_[static_cast<std::size_t>(row * w + column)];
  for (std::size_t i = 0; i < pixel.size(); ++i) {
    const double mixed = opacity * colour[i] + (1.0 - opacity) * pixel[i];
    pixel[i] = static_cast<std::uint8_t>(std::lround(mixed));
  }
}

void Picture::line(double column_0, double row_0, double column_1, double row_1, Colour colour) {
  const double columns = column_1 - column_0;
  const double rows = row_1 - row_0;
  if (!std::isfinite(columns) || !std::isfinite(rows)) return;
  Part seen;
  seen.cut(column_0, columns, static_cast<double>(width()));
  seen.cut(row_0, rows, static_cast<double>(height()));
  const double longer = std::max(std::abs(columns), std::abs(rows));
  const auto steps = std::max<std::int64_t>(1, std::llround(std::ceil(longer * seen.length())));
  for (std::int64_t i = 0; seen.length() >= 0.0 && i <= steps; ++i) {
    const double f =
        seen.from + seen.length() * static_cast<double>(i) / static_cast<double>(steps);
    set(std::llround(std::floor(column_0 + f * columns)),
        std::llround(std::floor(row_0 + f * rows)), colour);
  }
}

Picture Picture::enlarged(std::size_t factor) const {
  Picture large(area(width(), factor), area(height(), factor), {});
  for (std::size_t row = 0; row < large.height(); ++row) {
    for (std::size_t column = 0; column < large.width(); ++column) {
      large.pixels_[row * large.width() + column] =
          pixels_[(row / factor) * width() + column / factor];
    }
  }
  return large;
}

std::string Picture::png() const {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width());
  image.height = static_cast<png_uint_32>(height());
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = 0;
  std::string bytes;
  const auto write = [&](void* memory) {
    if (png_image_write_to_memory(&image, memory, &size, 0, pixels_.data(), 0, nullptr) == 0) {
      throw std::runtime_error(std::string("PNG: ") + image.message);
    }
  };
  write(nullptr);
  bytes.resize(size);
  write(bytes.data());
  bytes.resize(size);
  return bytes;
}

}  // namespace portolan
