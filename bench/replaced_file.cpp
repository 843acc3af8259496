// SPDX-License-Identifier: MIT
#include "replaced_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace spherepair {
namespace {

namespace fs = std::filesystem;

// /dev/stdout may lead to a regular file, but that one is open already: renaming would take it away from its writers.
bool names_open_file(const fs::path& path) {
  const std::string text = path.string();
  return fs::is_symlink(path) && (text.starts_with("/dev/") || text.starts_with("/proc/"));
}

bool replaceable(const fs::path& path) {
  return !fs::exists(path) || (fs::is_regular_file(path) && !names_open_file(path));
}

fs::path follow_links(const fs::path& path) {
  return fs::is_symlink(path) && replaceable(path) ? fs::weakly_canonical(path) : path;
}

}  // namespace

ReplacedFile::ReplacedFile(const fs::path& path) : path_(path), target_(follow_links(path)) {
  if (fs::is_directory(target_)) fail(EISDIR);
  if (replaceable(target_)) {
    open_beside();
  } else {
    descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC | O_APPEND);
  }
  if (descriptor_ < 0) fail(errno);
}

ReplacedFile::~ReplacedFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!beside_.empty()) ::unlink(beside_.c_str());
}

// Never a file that exists already: it may be another's.
void ReplacedFile::open_beside() {
  for (int attempt = 0; attempt < 1000; ++attempt) {
    const fs::path name = target_.string() + ".new" + (attempt ? std::to_string(attempt) : "");
    descriptor_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ >= 0) beside_ = name;
    if (descriptor_ >= 0 || errno != EEXIST) return;
  }
}

void ReplacedFile::fail(int error) const {
  throw std::invalid_argument(fmt::format("cannot write {}: {}", path_.string(), std::strerror(error)));
}

void ReplacedFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) fail(errno);
    if (written > 0) bytes.remove_prefix(size_t(written));
  }
}

void ReplacedFile::commit() {
  if (::close(std::exchange(descriptor_, -1)) != 0) fail(errno);
  if (beside_.empty()) return;
  if (::rename(beside_.c_str(), target_.c_str()) != 0) fail(errno);
  beside_.clear();
}

void check_writable(const fs::path& path) {
  const fs::path target = follow_links(path);
  if (replaceable(target) || fs::is_directory(target)) ReplacedFile trial(path);
}

bool same_file(const fs::path& left, const fs::path& right) {
  std::error_code error;
  if (fs::exists(left, error) && fs::exists(right, error)) return fs::equivalent(left, right, error);
  return fs::weakly_canonical(fs::absolute(left), error) == fs::weakly_canonical(fs::absolute(right), error);
}

}  // namespace spherepair
