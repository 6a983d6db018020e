// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace portolan {

/// A folder that nobody else of us reads or writes while this object lives. What the system
/// refuses is thrown as std::system_error with path and reason.
class Folder {
 public:
  using Announce = std::function<void(const std::string& change)>;

  /// Waits until the folder is free; throws std::runtime_error where it is not for so long.
  /// `announce` is called before each change.
  explicit Folder(std::filesystem::path path, Announce announce = {},
                  std::chrono::milliseconds patience = std::chrono::seconds(30));
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::filesystem::path path_of(const std::string& name) const { return path_ / name; }
  bool has(const std::string& name) const;
  bool has_folder(const std::string& name) const;
  std::vector<std::string> names_that_begin_with(const std::string& prefix) const;

  /// The content of a regular file of at most `max_bytes` [byte].
  std::string read(const std::string& name, std::size_t max_bytes) const;

  /// Makes a new file and returns when its content is on the disk.
  void write(const std::string& name, const std::string& content);
  /// Puts `from` in the place of `to`.
  void rename(const std::string& from, const std::string& to);
  void remove(const std::string& name);
  /// Returns when all names are on the disk.
  void sync();

 private:
  void announce(const std::string& change) const;

  std::filesystem::path path_;
  Announce announce_;
  int descriptor_ = -1;
};

}  // namespace portolan
