// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "portolan/map_file.hpp"
#include "portolan/outcome.hpp"
#include "portolan/pose.hpp"

namespace portolan::fuzz {

/// The bytes as files: one ends and the next begins at a line `====`.
inline std::vector<std::string> split(const std::uint8_t* data, std::size_t size) {
  constexpr std::string_view kBorder = "\n====\n";
  const std::string all(data, data + size);
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = 0; end != std::string::npos; begin = end + kBorder.size()) {
    end = all.find(kBorder, begin);
    parts.push_back(all.substr(begin, end == std::string::npos ? end : end - begin));
  }
  return parts;
}

/// Takes values of any type from the bytes, zeros where they have come to an end.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  template <class T>
  T next() {
    T value{};
    const std::size_t n = std::min(sizeof(T), size_);
    if (n > 0) std::memcpy(&value, data_, n);
    data_ += n;
    size_ -= n;
    return value;
  }
  template <class T>
  void fill(T& value) {
    value = next<T>();
  }
  template <class T>
  std::vector<T> all() {
    std::vector<T> values;
    while (size_ >= sizeof(T)) values.push_back(next<T>());
    return values;
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

[[noreturn]] inline void fail(const std::string& what) {
  std::cerr << what << std::endl;
  std::abort();
}

/// What a mapper makes of an observation that comes twice, from two places.
template <class Mapper, class Z>
Mapper insert_twice(Mapper mapper, const Z& z) {
  Pose T_map_sensor = Pose::Identity();
  if (mapper.insert(z, T_map_sensor) == Outcome::unusable) return mapper;
  T_map_sensor.translation().x() = 0.5;
  mapper.insert(z, T_map_sensor);
  return mapper;
}

/// A loader refuses a file with an exception, or what it makes of it is saved, loaded and saved
/// again to the same files.
template <class Read, class Write>
void load_and_save(const FileSet& files, Read read, Write write) {
  const auto loaded = [&]() -> std::optional<decltype(read(files))> {
    try {
      return read(files);
    } catch (const std::exception&) {
      return std::nullopt;
    }
  }();
  if (!loaded) return;
  const FileSet written = write(*loaded);
  if (!written.empty() && write(read(written)) != written) fail("saved again it is another map");
}

}  // namespace portolan::fuzz
