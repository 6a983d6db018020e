// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/pgm.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace portolan {

namespace {

constexpr std::size_t kMaxSide = 1000000;  // [pixel]

// Reads the header's numbers one after the other; comments run from # to the end of their line.
class Header {
 public:
  Header(const std::string& bytes, const std::string& file) : bytes_(bytes), file_(file) {
    if (bytes.compare(0, 2, "P5") != 0) fail("not a binary PGM (P5)");
  }

  std::size_t next(const char* what, std::size_t largest) {
    skip_space();
    std::size_t value = 0;
    for (; at_ < bytes_.size() && std::isdigit(static_cast<unsigned char>(bytes_[at_])); ++at_) {
      value = 10 * value + static_cast<std::size_t>(bytes_[at_] - '0');
      if (value > largest) fail(std::string(what) + " is too large");
    }
    if (value == 0) fail(std::string(what) + " is missing or 0");
    return value;
  }

  // Where the pixels begin: one white space behind the header.
  std::size_t end() const { return at_ + 1; }

  [[noreturn]] void fail(const std::string& reason) const {
    throw std::runtime_error(file_ + ": " + reason);
  }

 private:
  void skip_space() {
    for (; at_ < bytes_.size(); ++at_) {
      if (bytes_[at_] == '#') at_ = std::min(bytes_.find('\n', at_), bytes_.size() - 1);
      if (!std::isspace(static_cast<unsigned char>(bytes_[at_]))) return;
    }
  }

  const std::string& bytes_;
  const std::string& file_;
  std::size_t at_ = 2;
};

}  // namespace

std::string to_bytes(const Pgm& pgm) {
  std::string bytes =
      "P5\n" + std::to_string(pgm.width) + " " + std::to_string(pgm.height) + "\n255\n";
  bytes.append(pgm.pixels.begin(), pgm.pixels.end());
  return bytes;
}

Pgm read_pgm(const std::string& bytes, const std::string& file) {
  Header header(bytes, file);
  Pgm pgm;
  pgm.width = header.next("width", kMaxSide);
  pgm.height = header.next("height", kMaxSide);
  if (header.next("largest value", 65535) != 255) header.fail("the largest value must be 255");
  if (bytes.size() != header.end() + pgm.width * pgm.height) {
    header.fail("its size does not fit its header");
  }
  pgm.pixels.assign(bytes.begin() + static_cast<std::ptrdiff_t>(header.end()), bytes.end());
  return pgm;
}

}  // namespace portolan
