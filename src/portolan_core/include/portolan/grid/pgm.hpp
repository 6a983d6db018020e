// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace portolan {

/// A grey picture, rows from the top, one byte a pixel.
struct GreyPicture {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::uint8_t> pixels;
};

/// The bytes of a binary PGM file (P5).
std::string to_pgm(const GreyPicture& picture);

/// Reads a binary PGM file. Throws std::runtime_error that says what is wrong with it: another
/// format, sizes that do not fit the data, more than 8 bits a pixel.
GreyPicture from_pgm(const std::string& bytes);

}  // namespace portolan
