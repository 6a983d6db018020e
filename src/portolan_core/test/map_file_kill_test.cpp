// SPDX-License-Identifier: BSD-3-Clause
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "map_file_fixture.hpp"

namespace portolan {
namespace {

class MapFileKill : public MapFileTest {};

/// How many changes a save of a pair over an old one makes.
int count_changes(const fs::path& folder) {
  int changes = 0;
  map_file_detail::save_files(folder, pair_of(1), [&](const std::string&) { ++changes; });
  return changes;
}

TEST_F(MapFileKill, ARefusalAtAnyChangeLeavesAWholeSet) {
  const int changes = count_changes(folder);
  int old_ones = 0;
  for (int at = 0; at < changes; ++at) {
    save_files(folder, pair_of(1));
    int change = 0;
    const auto refuse = [&](const std::string& name) {
      if (change++ == at) throw std::runtime_error("refused to " + name);
    };
    EXPECT_THROW(map_file_detail::save_files(folder, pair_of(2), refuse), std::runtime_error);
    const bool is_old = names().count(".portolan_commit") == 0 && saved() == 1;
    if (is_old) {
      ++old_ones;
      EXPECT_EQ(names(), (std::set<std::string>{"map.pgm", "map.yaml"})) << "change " << at;
    }
    EXPECT_EQ(saved(), is_old ? 1 : 2) << "change " << at;
  }
  EXPECT_GE(old_ones, 12);  // until the first file is in its place everything is taken back
  EXPECT_LT(old_ones, changes);
}

/// A process that saves and is gone right before change number `at`; whether it got there.
bool save_and_die(const fs::path& folder, int number, int at) {
  const int code = exit_code_of([&] {
    int change = 0;
    map_file_detail::save_files(folder, pair_of(number), [&](const std::string&) {
      if (change++ == at) ::_exit(1);
    });
    return 0;
  });
  return code == 1;
}

TEST_F(MapFileKill, DeathAtAnyChangeLeavesAWholeSet) {
  const int changes = count_changes(folder);
  std::set<int> seen;
  for (int at = 0; at < changes; ++at) {
    save_files(folder, pair_of(1));
    ASSERT_TRUE(save_and_die(folder, 2, at));
    seen.insert(saved());
    recover(folder);
    EXPECT_EQ(names(), (std::set<std::string>{"map.pgm", "map.yaml"})) << "change " << at;
  }
  EXPECT_EQ(seen, (std::set<int>{1, 2}));
}

TEST_F(MapFileKill, DeathDuringRecoveryLeavesAWholeSet) {
  const int changes = count_changes(folder);
  for (int first = 0; first < changes; ++first) {
    for (int second = 0; second < 10; ++second) {
      save_files(folder, pair_of(1));
      ASSERT_TRUE(save_and_die(folder, 2, first));
      ASSERT_TRUE(save_and_die(folder, 3, second));
      const int number = saved();
      ASSERT_TRUE(number == 1 || number == 2) << number << " after " << first << ", " << second;
    }
  }
}

[[noreturn]] void save_for_ever(const fs::path& folder, int number) {
  try {
    for (;; number += 2) save_files(folder, pair_of(number));
  } catch (...) {
  }
  ::_exit(1);
}

TEST_F(MapFileKill, KillLeavesAWholeSet) {
  save_files(folder, pair_of(0));
  std::mt19937_64 random(8);
  std::uniform_int_distribution<int> microseconds(0, 12000);
  int number = 0;
  for (int round = 0; round < 100; ++round) {
    const pid_t child = ::fork();
    if (child == 0) save_for_ever(folder, number + 1);
    std::this_thread::sleep_for(std::chrono::microseconds(microseconds(random)));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
    const int next = saved();
    ASSERT_GE(next, number);
    number = next;
  }
  EXPECT_GT(number, 0);
}

/// A process that saves a hundred times and exits with 0 if nothing kept it from doing so.
pid_t start_saver(const fs::path& folder, int number) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  ::_exit(message_of([&] {
            for (int i = 0; i < 100; ++i) save_files(folder, pair_of(number + 2 * i));
          }) == "nothing was thrown"
              ? 0
              : 1);
}

TEST_F(MapFileKill, TwoSaversAndALoaderDoNotMixTheirSets) {
  save_files(folder, pair_of(0));
  for (const pid_t child : {start_saver(folder, 1), start_saver(folder, 2)}) {
    int status = 0;
    while (::waitpid(child, &status, WNOHANG) == 0) ASSERT_GE(saved(), 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  }
  EXPECT_TRUE(saved() == 199 || saved() == 200) << saved();
}

}  // namespace
}  // namespace portolan
