// SPDX-License-Identifier: MIT
#include "bench/formats/growing_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "bench/formats/files.h"
#include "common/files/replaced_file.h"

namespace spherepair {
namespace {

[[noreturn]] void fail(const std::string& name) {
  throw std::invalid_argument(fmt::format("cannot write {}: {}", name, std::strerror(errno)));
}

void write_all(int descriptor, std::string_view text, const std::string& name) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno != EINTR) fail(name);
    if (written > 0) text.remove_prefix(size_t(written));
  }
}

}  // namespace

GrowingFile::~GrowingFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void GrowingFile::add(std::string_view text) {
  if (name_.empty()) return;
  if (descriptor_ < 0) return open(text);
  write_all(descriptor_, text, name_);
}

void GrowingFile::open(std::string_view first) {
  const bool printed = name_ == kStandardOutput, replaced = !printed && is_replaced(name_);
  if (printed) std::fflush(stdout);
  if (replaced) write_file(name_, std::string(first));
  descriptor_ = printed ? ::dup(STDOUT_FILENO) : ::open(follow_links(name_).c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (descriptor_ < 0) fail(name_);
  if (!replaced) write_all(descriptor_, first, name_);
}

}  // namespace spherepair
