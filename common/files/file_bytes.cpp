// SPDX-License-Identifier: MIT
#include "common/files/file_bytes.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "common/backend/backend.h"
#include "common/backend/growing_list.h"
#include "common/scene/host_buffer.h"

namespace spherepair {
namespace {

constexpr size_t reserve = 1 << 16;  // bytes by which a file may be longer than its reported size

[[noreturn]] void fail_to_read(const std::string& name, int error) {
  throw std::invalid_argument(fmt::format("cannot read {}: {}", name, std::strerror(error)));
}

// Whether the name is a descriptor's, also one that is open on a regular file: `/dev/stdin <file`.
bool is_descriptor(std::string_view name) {
  return name == "/dev/stdin" || name.starts_with("/dev/fd/") || name.starts_with("/proc/self/fd/");
}

struct Descriptor {
  Descriptor(const std::string& name, bool standard_input)
      : value(standard_input ? ::dup(STDIN_FILENO) : ::open(name.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (value < 0) fail_to_read(name, errno);
  }
  ~Descriptor() { ::close(value); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int value;
};

}  // namespace

FileBytes::FileBytes(const std::filesystem::path& path) : name_(path == "-" ? "standard input" : path.string()) {
  const Descriptor file(name_, path == "-");
  struct stat status {};
  if (::fstat(file.value, &status) != 0) fail_to_read(name_, errno);
  if (S_ISDIR(status.st_mode)) fail_to_read(name_, EISDIR);
  stream_ = path == "-" || !S_ISREG(status.st_mode) || is_descriptor(name_);
  const size_t size = S_ISREG(status.st_mode) ? size_t(status.st_size) : 0;
  if (!fits_in_memory(size))
    throw BackendError(
        fmt::format("{} has {} bytes, which do not fit in memory: split it, or use a machine with more", name_, size));
  bytes_.reserve(size + reserve);
  advise_large_pages(bytes_.data(), bytes_.capacity());
  bytes_.resize(size + reserve);
  size_t done = 0;
  while (const ssize_t count = ::read(file.value, bytes_.data() + done, bytes_.size() - done)) {
    if (count < 0 && errno != EINTR) fail_to_read(name_, errno);
    if (count > 0) done += size_t(count);
    if (done == bytes_.size()) bytes_.resize(2 * done);
  }
  bytes_.resize(done);
}

void FileBytes::fail_at_line(uint64_t line, std::string_view expected, std::string_view found) const {
  throw std::invalid_argument(fmt::format("{}, line {}: expected {}, found {}", name_, line, expected, found));
}

void FileBytes::fail_at_byte(uint64_t offset, std::string_view expected, std::string_view found) const {
  throw std::invalid_argument(fmt::format("{}, byte {}: expected {}, found {}", name_, offset, expected, found));
}

std::string_view kind_of(std::string_view bytes) {
  using namespace std::string_view_literals;
  static constexpr std::pair<std::string_view, std::string_view> kinds[] = {
      {"\x93NUMPY"sv, "an NPY file"},
      {"PK\x03\x04"sv, "a zip archive (.npz, .zip)"},
      {"\x1f\x8b"sv, "a gzip file"},
      {"BZh"sv, "a bzip2 file"},
      {"\xfd"
       "7zXZ"sv,
       "an xz file"},
      {"\x28\xb5\x2f\xfd"sv, "a Zstandard file"},
      {"\x89HDF"sv, "an HDF5 file"},
      {"\x89PNG"sv, "a PNG image"},
      {"%PDF"sv, "a PDF document"},
      {"\x7f"
       "ELF"sv,
       "a program"},
      {"\xff\xfe"sv, "UTF-16 text"},
      {"\xfe\xff"sv, "UTF-16 text"}};
  for (const auto& [magic, name] : kinds)
    if (bytes.starts_with(magic)) return name;
  return {};
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
