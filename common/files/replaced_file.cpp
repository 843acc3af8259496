// SPDX-License-Identifier: MIT
#include "common/files/replaced_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace spherepair {
namespace {

namespace fs = std::filesystem;

constinit FileNews told = {[](const std::string&) {}, [](const std::string&) {}, [](const fs::path&) {}};

// /dev/stdout may link to a regular file that is already open: replacing it would detach its writers.
bool names_open_file(const fs::path& path) {
  const std::string text = path.string();
  return fs::is_symlink(path) && (text.starts_with("/dev/") || text.starts_with("/proc/"));
}

bool replaceable(const fs::path& path) {
  return !fs::exists(path) || (fs::is_regular_file(path) && !names_open_file(path));
}

[[noreturn]] void fail_to_write(const fs::path& path, int error) {
  throw std::invalid_argument(fmt::format("cannot write {}: {}", path.string(), std::strerror(error)));
}

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : "."; }

// Syncs the folder. An unreadable folder is no error, since the file exists already.
void sync_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

void tell_of_files(const FileNews& news) { told = news; }

fs::path follow_links(const fs::path& path) try {
  fs::path target = path;
  while (replaceable(target) && fs::is_symlink(target)) target = target.parent_path() / fs::read_symlink(target);
  return target;
} catch (const fs::filesystem_error& error) {
  fail_to_write(path, error.code().value());
}

ReplacedFile::ReplacedFile(const fs::path& path) : path_(path), target_(follow_links(path)) {
  if (fs::is_directory(target_)) fail(EISDIR);
  if (fs::exists(target_) && ::access(target_.c_str(), W_OK) != 0) fail(errno);
  if (!replaceable(target_)) {
    descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC | O_APPEND);
  } else {
    descriptor_ = ::open(folder_of(target_).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
    nameless_ = descriptor_ >= 0;
    if (!nameless_) open_temporary();
  }
  if (descriptor_ < 0) fail(errno);
}

ReplacedFile::~ReplacedFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (temporary_.empty()) return;
  ::unlink(temporary_.c_str());
  told.forgotten(temporary_);
}

// Never the name of an existing file: it may belong to another process.
bool ReplacedFile::take_temporary_name(const std::function<bool(const std::string&)>& take) {
  for (int attempt = 0; attempt < 1000; ++attempt) {
    const std::string name = target_.string() + ".new" + (attempt ? std::to_string(attempt) : "");
    if (take(name)) {
      told.temporary(temporary_ = name);
      return true;
    }
    if (errno != EEXIST) return false;
  }
  return false;
}

bool ReplacedFile::open_temporary() {
  return take_temporary_name([&](const std::string& name) {
    descriptor_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    return descriptor_ >= 0;
  });
}

void ReplacedFile::fail(int error) const { fail_to_write(path_, error); }

void ReplacedFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) fail(errno);
    if (written > 0) bytes.remove_prefix(size_t(written));
  }
}

std::string ReplacedFile::name_for_children() {
  ::fcntl(descriptor_, F_SETFD, 0);  // child processes inherit it
  return fmt::format("/proc/self/fd/{}", descriptor_);
}

// linkat cannot replace a file, but rename can: the file is linked under a temporary name first. Its bytes are synced
// before that, so that a loss of power leaves either the old file or the new one.
void ReplacedFile::commit() {
  const std::string open_file = fmt::format("/proc/self/fd/{}", descriptor_);
  const auto link = [&](const std::string& name) {
    return ::linkat(AT_FDCWD, open_file.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
  };
  if ((nameless_ || !temporary_.empty()) && ::fsync(descriptor_) != 0) fail(errno);
  if (nameless_ && !take_temporary_name(link)) fail(errno);
  if (::close(std::exchange(descriptor_, -1)) != 0) fail(errno);
  if (temporary_.empty()) return;
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  told.forgotten(temporary_);
  temporary_.clear();
  told.written(path_);
  sync_folder(folder_of(target_));
}

bool is_replaced(const fs::path& path) { return replaceable(follow_links(path)); }

void check_writable(const fs::path& path) {
  const fs::path target = follow_links(path);
  if (replaceable(target) || fs::is_directory(target)) ReplacedFile trial(path);
}

}  // namespace spherepair
