// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace portolan {

/// A grey picture as a binary PGM (P5) with a byte a pixel holds it: rows from the top.
struct Pgm {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::uint8_t> pixels;  ///< width * height
};

std::string to_bytes(const Pgm& pgm);

/// Throws std::runtime_error that names `file` where the bytes are no such picture.
Pgm read_pgm(const std::string& bytes, const std::string& file);

}  // namespace portolan
