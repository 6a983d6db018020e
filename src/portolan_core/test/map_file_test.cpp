// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/map_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <csignal>

#include "folder.hpp"
#include "map_file_fixture.hpp"

namespace portolan {
namespace {

class MapFile : public MapFileTest {};

TEST_F(MapFile, GivesBackWhatItWasGiven) {
  std::string bytes;
  for (int i = 0; i < 256; ++i) bytes += static_cast<char>(i);
  save_files(folder, {{"map.pgm", bytes}, {"empty.yaml", ""}});
  EXPECT_EQ(load_file(folder / "map.pgm", kMaxBytes), bytes);
  EXPECT_EQ(load_file(folder / "empty.yaml", kMaxBytes), "");
  EXPECT_EQ(names(), (std::set<std::string>{"map.pgm", "empty.yaml"}));
}

TEST_F(MapFile, ReplacesItsOwnFilesAndNoOthers) {
  put("notes.txt", "mine");
  save_files(folder, pair_of(1));
  save_files(folder, pair_of(2));
  EXPECT_EQ(saved(), 2);
  EXPECT_EQ(load_file(folder / "notes.txt", kMaxBytes), "mine");
}

TEST_F(MapFile, RefusesNamesThatLeaveTheFolderOrHide) {
  const std::vector<std::string> bad = {"",     ".",    "..",   "../map", "a/b",
                                        "/map", ".map", "a..b", "a\nb",   std::string("a\0b", 3)};
  for (const std::string& name : bad) {
    const std::string expected = "refused file name '" + name.substr(0, name.find('\0'));
    EXPECT_EQ(message_of([&] {
                save_files(folder, {{name, "1"}, {"good", "2"}});
              }).find(expected),
              0u)
        << name;
    EXPECT_EQ(message_of([&] { load_files(folder, {name}, kMaxBytes); }).find(expected), 0u)
        << name;
  }
  EXPECT_TRUE(names().empty());
}

TEST_F(MapFile, SaysWhichFolderIsMissing) {
  const fs::path missing = folder / "missing";
  const std::string expected = "open folder " + missing.string() + ": No such file or directory";
  EXPECT_NE(message_of([&] { save_files(missing, pair_of(1)); }).find(expected), std::string::npos);
  EXPECT_NE(message_of([&] { recover(missing); }).find(expected), std::string::npos);
  EXPECT_NE(message_of([&] { load_file(missing / "map.pgm", kMaxBytes); }).find(expected),
            std::string::npos);
}

TEST_F(MapFile, DoesNotWaitForEverForAProcessThatHoldsTheFolder) {
  const int held = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(::flock(held, LOCK_EX), 0);
  const auto enter = [&] { Folder(folder, {}, std::chrono::milliseconds(20)); };
  EXPECT_NE(message_of(enter).find("cannot lock folder " + folder.string()), std::string::npos);
  ::close(held);
  EXPECT_NO_THROW(enter());
}

TEST_F(MapFile, LoadsWhatFilesName) {
  save_files(folder, {{"a", "b"}, {"b", "c"}, {"c", "a"}, {"d", "e"}});
  const auto named = [](const FileSet& found) {
    std::vector<std::string> names;
    for (const auto& [name, content] : found) names.push_back(content);
    return names;
  };
  EXPECT_EQ(load_files(folder, {"a"}, kMaxBytes, named),
            (FileSet{{"a", "b"}, {"b", "c"}, {"c", "a"}}));
  EXPECT_NE(message_of([&] { load_files(folder, {"d"}, kMaxBytes, named); }).find("cannot read"),
            std::string::npos);
  put("f", "../a");
  EXPECT_NE(message_of([&] { load_files(folder, {"f"}, kMaxBytes, named); }).find("refused"),
            std::string::npos);
}

TEST_F(MapFile, SaysWhatItCannotLoad) {
  put("large", "12345");
  fs::create_directory(folder / "folder");
  const auto message = [&](const char* name) {
    return message_of([&] { load_file(folder / name, 4); });
  };
  EXPECT_NE(message("absent").find("absent: No such file or directory"), std::string::npos);
  EXPECT_NE(message("folder").find("folder: Is a directory"), std::string::npos);
  EXPECT_NE(message("large").find("it has 5 bytes, allowed are 4"), std::string::npos);
  EXPECT_EQ(load_file(folder / "large", 5), "12345");
}

TEST_F(MapFile, DoesNotWaitForAPipe) {
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_NE(message_of([&] { load_file(folder / "pipe", kMaxBytes); }).find("not a regular file"),
            std::string::npos);
}

TEST_F(MapFile, DoesNotReplaceAFolder) {
  save_files(folder, {{"map.pgm", "1"}});
  fs::create_directory(folder / "map.yaml");
  EXPECT_NE(message_of([&] { save_files(folder, pair_of(2)); }).find("map.yaml: it is a folder"),
            std::string::npos);
  EXPECT_EQ(load_file(folder / "map.pgm", kMaxBytes), "1");
  EXPECT_EQ(names(), (std::set<std::string>{"map.pgm", "map.yaml"}));
}

TEST_F(MapFile, AFullDiskLeavesTheOldFiles) {
  save_files(folder, pair_of(1));
  // A limit on the size of files refuses bytes in the middle of a file, as a full disk does.
  const int code = exit_code_of([&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{10000, 10000};
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) return 1;
    const std::string message = message_of([&] { save_files(folder, pair_of(2)); });
    return message.find("map.pgm: File too large") == std::string::npos ? 2 : 0;
  });
  EXPECT_EQ(code, 0);
  EXPECT_EQ(saved(), 1);
  EXPECT_EQ(names(), (std::set<std::string>{"map.pgm", "map.yaml"}));
}

TEST_F(MapFile, AReadOnlyFolderCanBeLoadedButNotSaved) {
  save_files(folder, pair_of(1));
  put(".portolan_new.map.pgm", "left by a killed saver");
  for (const std::string& name : kPair) fs::permissions(folder / name, fs::perms(0444));
  fs::permissions(folder, fs::perms(0555));
  const int code = exit_code_of([&] {
    const uid_t nobody = 65534;  // permissions do not bind root
    if (::geteuid() == 0 && ::seteuid(nobody) != 0) return 1;
    if (saved() != 1) return 2;
    const std::string message = message_of([&] { save_files(folder, pair_of(2)); });
    return message.find(folder.string()) == std::string::npos ||
                   message.find("Permission denied") == std::string::npos
               ? 3
               : 0;
  });
  EXPECT_EQ(code, 0);
  EXPECT_EQ(saved(), 1);
}

TEST_F(MapFile, ADamagedJournalIsNotGuessedAt) {
  save_files(folder, pair_of(1));
  for (const char* journal : {"", "portolan commit 1\nmap.pgm\n", "portolan commit 9\n/end\n",
                              "portolan commit 1\n../map.pgm\n/end\n"}) {
    put(".portolan_commit", journal);
    EXPECT_THROW(saved(), std::runtime_error) << journal;
    EXPECT_THROW(save_files(folder, pair_of(2)), std::runtime_error) << journal;
  }
  fs::remove(folder / ".portolan_commit");
  EXPECT_EQ(saved(), 1);
}

}  // namespace
}  // namespace portolan
