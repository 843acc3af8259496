// SPDX-License-Identifier: MIT
#include "file_bytes.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace spherepair {
namespace {

[[noreturn]] void fail_to_read(const std::string& name, int error) {
  throw std::invalid_argument(fmt::format("cannot read {}: {}", name, std::strerror(error)));
}

struct Descriptor {
  explicit Descriptor(const std::string& name) : value(::open(name.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (value < 0) fail_to_read(name, errno);
  }
  ~Descriptor() { ::close(value); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int value;
};

}  // namespace

FileBytes::FileBytes(const std::filesystem::path& path) : name_(path.string()) {
  const Descriptor file(name_);
  struct stat status {};
  if (::fstat(file.value, &status) != 0) fail_to_read(name_, errno);
  if (S_ISDIR(status.st_mode)) fail_to_read(name_, EISDIR);
  if (S_ISREG(status.st_mode) && status.st_size > 0) {
    void* start = ::mmap(nullptr, size_t(status.st_size), PROT_READ, MAP_PRIVATE, file.value, 0);
    mapped_ = start != MAP_FAILED;
    if (mapped_) bytes_ = {static_cast<const char*>(start), size_t(status.st_size)};
  }
  if (!mapped_) read_whole(file.value);
}

FileBytes::~FileBytes() {
  if (mapped_) ::munmap(const_cast<char*>(bytes_.data()), bytes_.size());
}

void FileBytes::read_whole(int descriptor) {
  std::array<char, 1 << 16> chunk;
  while (const ssize_t count = ::read(descriptor, chunk.data(), chunk.size())) {
    if (count > 0) buffer_.append(chunk.data(), size_t(count));
    if (count < 0 && errno != EINTR) fail_to_read(name_, errno);
  }
  bytes_ = buffer_;
}

void FileBytes::fail_at_line(uint64_t line, std::string_view expected, std::string_view found) const {
  throw std::invalid_argument(fmt::format("{}, line {}: expected {}, found {}", name_, line, expected, found));
}

void FileBytes::fail_at_byte(uint64_t offset, std::string_view expected, std::string_view found) const {
  throw std::invalid_argument(fmt::format("{}, byte {}: expected {}, found {}", name_, offset, expected, found));
}

std::string in_quotes(std::string_view text) {
  constexpr size_t most = 60;
  std::string shown = "'";
  for (const char c : text.substr(0, most)) {
    if (c >= ' ' && c <= '~')
      shown += c;
    else
      shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
  }
  return shown + (text.size() > most ? "...'" : "'");
}

}  // namespace spherepair
