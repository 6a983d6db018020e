// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/map_file.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "folder.hpp"

// A save writes every file under a temporary name, then a journal that lists them, and only then
// renames them into place. The set is valid from the moment the journal has its name: what a
// reader or the next saver finds listed there is renamed by them if it was not yet. Each stage is
// on the disk before the next one begins.

namespace portolan {

namespace {

const std::string kTemporary = ".portolan_new.";
const std::string kJournal = ".portolan_commit";
const std::string kJournalBegins = "portolan commit 1";
const std::string kJournalEnds = "/end";  // no file has a '/' in its name
constexpr std::size_t kMaxJournalBytes = 1 << 20;

std::string temporary(const std::string& name) { return kTemporary + name; }

void check_name(const std::string& name) {
  if (!is_bare_name(name)) {
    throw std::runtime_error("refused file name '" + name +
                             "': it must be a bare name that does not begin with a dot");
  }
}

std::string journal_of(const FileSet& files) {
  std::string text = kJournalBegins + "\n";
  for (const auto& [name, content] : files) text += name + "\n";
  return text + kJournalEnds + "\n";
}

std::vector<std::string> journal_names(const Folder& folder) {
  std::istringstream text(folder.read(kJournal, kMaxJournalBytes));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  if (lines.size() < 2 || lines.front() != kJournalBegins || lines.back() != kJournalEnds) {
    throw std::runtime_error(folder.path_of(kJournal).string() +
                             " is damaged: remove it to go on with the files as they are");
  }
  std::vector<std::string> names(lines.begin() + 1, lines.end() - 1);
  std::for_each(names.begin(), names.end(), check_name);
  return names;
}

void put_in_place(Folder& folder, const std::string& name) {
  if (folder.has(temporary(name))) folder.rename(temporary(name), name);
}

void close_journal(Folder& folder) {
  folder.sync();
  folder.remove(kJournal);
  folder.sync();
}

void remove_temporaries(Folder& folder) {
  for (const std::string& name : folder.names_that_begin_with(kTemporary)) folder.remove(name);
}

void finish_committed(Folder& folder) {
  for (const std::string& name : journal_names(folder)) put_in_place(folder, name);
  close_journal(folder);
}

void recover(Folder& folder) {
  if (folder.has(kJournal)) finish_committed(folder);
  remove_temporaries(folder);
}

void write_temporaries(Folder& folder, const FileSet& files) {
  for (const auto& [name, content] : files) {
    if (folder.has_folder(name)) {
      throw std::runtime_error("cannot replace " + folder.path_of(name).string() +
                               ": it is a folder");
    }
    folder.write(temporary(name), content);
  }
  folder.write(temporary(kJournal), journal_of(files));
  folder.sync();
}

void commit(Folder& folder) {
  folder.rename(temporary(kJournal), kJournal);
  folder.sync();
}

/// Takes back a set of which no file is in its place yet. Its journal goes first: as long as that
/// stands the temporaries are needed.
void withdraw(Folder& folder) {
  try {
    folder.remove(kJournal);
    folder.sync();
    remove_temporaries(folder);
  } catch (const std::exception&) {
    // The fault that brought us here is the one to report; the rest is left to `recover`.
  }
}

}  // namespace

bool is_bare_name(const std::string& name) {
  const auto is_bad = [](unsigned char c) { return c == '/' || c < 0x20 || c == 0x7f; };
  return !name.empty() && name.front() != '.' && name.find("..") == std::string::npos &&
         std::none_of(name.begin(), name.end(), is_bad);
}

namespace map_file_detail {

void save_files(const std::filesystem::path& folder, const FileSet& files,
                const std::function<void(const std::string&)>& before) {
  for (const auto& [name, content] : files) check_name(name);
  Folder locked(folder, before);
  recover(locked);
  bool any_in_place = false;
  try {
    write_temporaries(locked, files);
    commit(locked);
    for (const auto& [name, content] : files) {
      put_in_place(locked, name);
      any_in_place = true;
    }
    close_journal(locked);
  } catch (...) {
    if (!any_in_place) withdraw(locked);
    throw;
  }
}

}  // namespace map_file_detail

void save_files(const std::filesystem::path& folder, const FileSet& files) {
  map_file_detail::save_files(folder, files, {});
}

void recover(const std::filesystem::path& folder) {
  Folder locked(folder);
  recover(locked);
}

FileSet load_files(const std::filesystem::path& folder, const std::vector<std::string>& names,
                   std::size_t max_bytes) {
  return load_files(folder, names, max_bytes,
                    [](const FileSet& /*found*/) { return std::vector<std::string>{}; });
}

FileSet load_files(const std::filesystem::path& folder, const std::vector<std::string>& names,
                   std::size_t max_bytes,
                   const std::function<std::vector<std::string>(const FileSet& found)>& more) {
  std::for_each(names.begin(), names.end(), check_name);
  Folder locked(folder);
  if (locked.has(kJournal)) finish_committed(locked);
  FileSet files;
  const auto read = [&](const std::string& name) {
    check_name(name);
    if (files.count(name) == 0) files[name] = locked.read(name, max_bytes);
  };
  std::for_each(names.begin(), names.end(), read);
  for (std::size_t before = 0; before < files.size();) {
    before = files.size();
    const std::vector<std::string> further = more(files);
    std::for_each(further.begin(), further.end(), read);
  }
  return files;
}

std::string load_file(const std::filesystem::path& path, std::size_t max_bytes) {
  Folder folder(path.has_parent_path() ? path.parent_path() : ".");
  if (folder.has(kJournal)) finish_committed(folder);
  return folder.read(path.filename().string(), max_bytes);
}

}  // namespace portolan
