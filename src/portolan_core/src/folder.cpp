// SPDX-License-Identifier: BSD-3-Clause
#include "folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace portolan {

namespace {

[[noreturn]] void refuse(const char* deed, const std::filesystem::path& path, int reason = errno) {
  throw std::system_error(reason, std::generic_category(),
                          std::string("cannot ") + deed + " " + path.string());
}

/// Repeats a system call that a signal interrupted.
template <class Call>
auto retried(Call call) {
  auto result = call();
  while (result == -1 && errno == EINTR) result = call();
  return result;
}

/// Closes an open file when it goes out of scope.
class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  ~Descriptor() {
    if (value_ >= 0) ::close(value_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int value() const { return value_; }

 private:
  int value_;
};

void write_all(int file, const std::string& content, const std::filesystem::path& path) {
  std::size_t done = 0;
  while (done < content.size()) {
    const ssize_t wrote =
        retried([&] { return ::write(file, content.data() + done, content.size() - done); });
    if (wrote < 0) refuse("write", path);
    done += static_cast<std::size_t>(wrote);
  }
}

std::string read_all(int file, std::size_t size, const std::filesystem::path& path) {
  std::string content(size, '\0');
  std::size_t done = 0;
  while (done < size) {
    const ssize_t got = retried([&] { return ::read(file, &content[done], size - done); });
    if (got < 0) refuse("read", path);
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  content.resize(done);
  return content;
}

/// The file's size [byte], where it is one that we read.
std::size_t checked_size(int file, std::size_t max_bytes, const std::filesystem::path& path) {
  struct stat status {};
  if (::fstat(file, &status) != 0) refuse("read", path);
  if (S_ISDIR(status.st_mode)) refuse("read", path, EISDIR);
  if (!S_ISREG(status.st_mode)) {
    throw std::runtime_error("cannot read " + path.string() + ": not a regular file");
  }
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size > max_bytes) {
    throw std::runtime_error("cannot read " + path.string() + ": it has " + std::to_string(size) +
                             " bytes, allowed are " + std::to_string(max_bytes));
  }
  return size;
}

bool has_no_locks(int reason) {
  return reason == EBADF || reason == EINVAL || reason == ENOLCK || reason == EOPNOTSUPP ||
         reason == ENOSYS;
}

}  // namespace

Folder::Folder(std::filesystem::path path, Announce announce)
    : path_(std::move(path)), announce_(std::move(announce)) {
  const int opened = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (opened < 0) refuse("open folder", path_);
  // The system drops the lock with the process that holds it, however that one ends.
  if (retried([&] { return ::flock(opened, LOCK_EX); }) != 0 && !has_no_locks(errno)) {
    const int reason = errno;
    ::close(opened);
    refuse("lock folder", path_, reason);
  }
  descriptor_ = opened;
}

Folder::~Folder() { ::close(descriptor_); }

bool Folder::has(const std::string& name) const {
  struct stat status {};
  const bool found = ::fstatat(descriptor_, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0;
  if (!found && errno != ENOENT) refuse("look at", path_of(name));
  return found;
}

bool Folder::has_folder(const std::string& name) const {
  struct stat status {};
  return ::fstatat(descriptor_, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 &&
         S_ISDIR(status.st_mode);
}

std::vector<std::string> Folder::names_that_begin_with(const std::string& prefix) const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path_)) {
    const std::string name = entry.path().filename().string();
    if (name.compare(0, prefix.size(), prefix) == 0) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string Folder::read(const std::string& name, std::size_t max_bytes) const {
  const auto path = path_of(name);
  const int flags = O_RDONLY | O_CLOEXEC | O_NONBLOCK;  // a pipe must not keep us waiting
  const Descriptor file(::openat(descriptor_, name.c_str(), flags));
  if (file.value() < 0) refuse("read", path);
  return read_all(file.value(), checked_size(file.value(), max_bytes, path), path);
}

void Folder::write(const std::string& name, const std::string& content) {
  const auto path = path_of(name);
  announce("create " + name);
  const int flags = O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC;
  const Descriptor file(::openat(descriptor_, name.c_str(), flags, 0666));
  if (file.value() < 0) refuse("create", path);
  announce("write " + name);
  write_all(file.value(), content, path);
  announce("sync " + name);
  if (retried([&] { return ::fsync(file.value()); }) != 0) refuse("write", path);
}

void Folder::rename(const std::string& from, const std::string& to) {
  announce("rename " + from + " to " + to);
  if (::renameat(descriptor_, from.c_str(), descriptor_, to.c_str()) != 0) {
    refuse("replace", path_of(to));
  }
}

void Folder::remove(const std::string& name) {
  announce("remove " + name);
  if (::unlinkat(descriptor_, name.c_str(), 0) != 0 && errno != ENOENT) {
    refuse("remove", path_of(name));
  }
}

void Folder::sync() {
  announce("sync the folder");
  const bool synced = retried([&] { return ::fsync(descriptor_); }) == 0;
  const bool has_no_sync = !synced && errno == EINVAL;  // some network file systems
  if (!synced && !has_no_sync) refuse("write folder", path_);
}

void Folder::announce(const std::string& change) const {
  if (announce_) announce_(change);
}

}  // namespace portolan
