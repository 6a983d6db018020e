// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "portolan/map_file.hpp"

namespace portolan {

namespace fs = std::filesystem;

inline constexpr std::size_t kMaxBytes = 1 << 22;
inline const std::vector<std::string> kPair = {"map.pgm", "map.yaml"};

/// A map's two files that say the same number; the larger one is not written at one stroke.
inline FileSet pair_of(int number, std::size_t size = 30000) {
  const std::string text = std::to_string(number);
  return {{"map.yaml", text}, {"map.pgm", text + " " + std::string(size, 'x')}};
}

/// The number that both files say; -1 where they disagree.
inline int number_of(const FileSet& files) {
  const int number = std::stoi(files.at("map.yaml"));
  return std::stoi(files.at("map.pgm")) == number ? number : -1;
}

inline std::string message_of(const std::function<void()>& deed) {
  try {
    deed();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

/// What a child process that does this exits with; -1 where a signal ended it.
inline int exit_code_of(const std::function<int()>& deed) {
  const pid_t child = ::fork();
  if (child == 0) {
    try {
      ::_exit(deed());
    } catch (...) {
      ::_exit(99);
    }
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Where killing a process shows the same as on a disk, but syncing costs nothing.
inline fs::path fast_folder() {
  const fs::path memory = "/dev/shm";
  return ::access(memory.c_str(), W_OK) == 0 ? memory : fs::temp_directory_path();
}

/// A test with a folder of its own.
class MapFileTest : public ::testing::Test {
 protected:
  MapFileTest() {
    std::string name = (fast_folder() / "portolan_map_file_XXXXXX").string();
    folder = ::mkdtemp(name.data());
  }
  ~MapFileTest() override {
    fs::permissions(folder, fs::perms::owner_all);
    fs::remove_all(folder);
  }

  std::set<std::string> names() const {
    std::set<std::string> all;
    for (const auto& entry : fs::directory_iterator(folder)) all.insert(entry.path().filename());
    return all;
  }
  int saved() const { return number_of(load_files(folder, kPair, kMaxBytes)); }
  void put(const std::string& name, const std::string& content) const {
    std::ofstream(folder / name) << content;
  }

  fs::path folder;
};

}  // namespace portolan
