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

}  // namespace

Picture::Picture(std::size_t width, std::size_t height, Colour background)
    : width_(width), pixels_(area(width, height), background) {}

void Picture::set(std::int64_t column, std::int64_t row, Colour colour) {
  const auto w = static_cast<std::int64_t>(width());
  const auto h = static_cast<std::int64_t>(height());
  if (column < 0 || row < 0 || column >= w || row >= h) return;
  pixels_[static_cast<std::size_t>(row * w + column)] = colour;
}

void Picture::line(double column_0, double row_0, double column_1, double row_1, Colour colour) {
  const double longer = std::max(std::abs(column_1 - column_0), std::abs(row_1 - row_0));
  const double most = 2.0 * static_cast<double>(width() + height());
  if (!(longer <= most)) return;
  const int steps = std::max(1, static_cast<int>(std::ceil(longer)));
  for (int i = 0; i <= steps; ++i) {
    const double f = static_cast<double>(i) / steps;
    set(std::llround(std::floor(column_0 + f * (column_1 - column_0))),
        std::llround(std::floor(row_0 + f * (row_1 - row_0))), colour);
  }
}

Picture Picture::enlarged(std::size_t factor) const {
  Picture large(width() * factor, height() * factor, {});
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
