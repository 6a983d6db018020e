// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace portolan {

/// A colour picture to look at, rows from the top.
class Picture {
 public:
  using Colour = std::array<std::uint8_t, 3>;  ///< red, green, blue

  /// Throws std::invalid_argument where a side is 0 or there would be over 2^28 pixels.
  Picture(std::size_t width, std::size_t height, Colour background);

  std::size_t width() const { return width_; }
  std::size_t height() const { return pixels_.size() / width_; }

  /// Sets one pixel; one outside of the picture is left out.
  void set(std::int64_t column, std::int64_t row, Colour colour);

  /// Mixes the colour into one pixel, by `opacity` in [0, 1].
  void mix(std::int64_t column, std::int64_t row, Colour colour, double opacity);

  /// A straight line of one pixel's width; what lies outside of the picture is left out.
  void line(double column_0, double row_0, double column_1, double row_1, Colour colour);

  /// Every pixel as a square of `factor` pixels a side.
  Picture enlarged(std::size_t factor) const;

  /// The bytes of a PNG file. The same picture gives the same bytes.
  std::string png() const;

 private:
  std::size_t width_;
  std::vector<Colour> pixels_;
};

}  // namespace portolan
