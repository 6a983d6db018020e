// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <png.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "portolan_ros/picture.hpp"

namespace portolan {

/// What any program sees in the bytes of a PNG file.
struct DecodedPng {
  explicit DecodedPng(const std::string& bytes) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_NE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()), 0);
    image.format = PNG_FORMAT_RGB;
    width = image.width;
    height = image.height;
    pixels.resize(PNG_IMAGE_SIZE(image));
    EXPECT_NE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr), 0);
  }

  Picture::Colour at(std::size_t column, std::size_t row) const {
    const std::uint8_t* pixel = &pixels[3 * (row * width + column)];
    return {pixel[0], pixel[1], pixel[2]};
  }

  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::uint8_t> pixels;
};

}  // namespace portolan
