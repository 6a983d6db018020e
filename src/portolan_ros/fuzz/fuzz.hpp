// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "portolan/map_file.hpp"

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

[[noreturn]] inline void fail(const std::string& what) {
  std::cerr << what << std::endl;
  std::abort();
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
