// SPDX-License-Identifier: BSD-3-Clause
#include "folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <stdexcept>
#include <system_error>
#include <thread>
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
  /// Leaves it to the caller to close it.
  int release() { return std::exchange(value_, -1); }

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

/// Waits for the lock of an open folder, where the file system has any. It is dropped with the
/// process that holds it, however that one ends; but that one may hang, or be stopped.
void lock(int folder, std::chrono::milliseconds patience, const std::filesystem::path& path) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (retried([&] { return ::flock(folder, LOCK_EX | LOCK_NB); }) != 0) {
    if (has_no_locks(errno)) return;
    if (errno != EWOULDBLOCK) refuse("lock folder", path);
    if (std::chrono::steady_clock::now() > end) {
      throw std::runtime_error("cannot lock folder " + path.string() +
                               ": somebody else does not let go of it");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

}  // namespace

Folder::Folder(std::filesystem::path path, Announce announce, std::chrono::milliseconds patience)
    : path_(std::move(path)), announce_(std::move(announce)) {
  Descriptor opened(::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.value() < 0) refuse("open folder", path_);
  lock(opened.value(), patience, path_);
  descriptor_ = opened.release();
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
