// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/pgm.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace portolan {

namespace {

/// Reads the words of the header one by one; comments reach from # to the end of their line.
class HeaderReader {
 public:
  explicit HeaderReader(const std::string& bytes) : bytes_(bytes) {}

  std::string word() {
    skip_blanks();
    const std::size_t begin = at_;
    while (at_ < bytes_.size() && !is_blank(bytes_[at_])) ++at_;
    return bytes_.substr(begin, at_ - begin);
  }

  std::size_t number() {
    constexpr std::size_t kMostDigits = 9;
    const std::string digits = word();
    const bool good = !digits.empty() && digits.size() <= kMostDigits &&
                      std::all_of(digits.begin(), digits.end(),
                                  [](unsigned char c) { return std::isdigit(c) != 0; });
    if (!good) throw std::runtime_error("its header lacks a number");
    return std::stoul(digits);
  }

  /// The first byte after the header: one blank ends it.
  std::size_t data_begin() const { return std::min(at_ + 1, bytes_.size()); }

 private:
  static bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

  void skip_blanks() {
    while (at_ < bytes_.size() && (is_blank(bytes_[at_]) || bytes_[at_] == '#')) {
      if (bytes_[at_] == '#') at_ = std::min(bytes_.find('\n', at_), bytes_.size() - 1);
      ++at_;
    }
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
};

}  // namespace

std::string to_pgm(const GreyPicture& picture) {
  std::string bytes =
      "P5\n" + std::to_string(picture.width) + " " + std::to_string(picture.height) + "\n255\n";
  bytes.append(picture.pixels.begin(), picture.pixels.end());
  return bytes;
}

GreyPicture from_pgm(const std::string& bytes) {
  HeaderReader header(bytes);
  if (header.word() != "P5") throw std::runtime_error("it is no binary PGM (P5)");
  GreyPicture picture;
  picture.width = header.number();
  picture.height = header.number();
  if (header.number() != 255) throw std::runtime_error("its pixels do not reach from 0 to 255");
  const std::size_t data = bytes.size() - header.data_begin();
  if (picture.width == 0 || picture.height == 0 || data % picture.width != 0 ||
      data / picture.width != picture.height) {
    throw std::runtime_error("it states " + std::to_string(picture.width) + " x " +
                             std::to_string(picture.height) + " pixels and holds " +
                             std::to_string(data));
  }
  picture.pixels.assign(bytes.begin() + static_cast<std::ptrdiff_t>(header.data_begin()),
                        bytes.end());
  return picture;
}

}  // namespace portolan
