// SPDX-License-Identifier: MIT
// Reads the bytes of a file, and throws errors that name the position in it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace spherepair {

// Reads the whole file and does not map it: if another process truncates a mapped file, reading it kills this one.
// Throws std::invalid_argument, or BackendError if the file does not fit in memory.
class FileBytes {
 public:
  explicit FileBytes(const std::filesystem::path& path);  // -: standard input
  FileBytes(std::string name, std::string bytes) : name_(std::move(name)), bytes_(std::move(bytes)) {}

  const std::string& name() const { return name_; }
  // Standard input, a pipe, /dev/fd/63: no extension tells its format.
  bool is_stream() const { return stream_; }
  std::string_view bytes() const { return bytes_; }

  // Throw std::invalid_argument: FILE, line 7: expected ..., found ...
  [[noreturn]] void fail_at_line(uint64_t line, std::string_view expected, std::string_view found) const;
  [[noreturn]] void fail_at_byte(uint64_t offset, std::string_view expected, std::string_view found) const;

 private:
  bool stream_ = false;
  std::string name_, bytes_;
};

// A whole number, lowest byte first.
inline uint64_t little_endian(std::string_view bytes) {
  uint64_t value = 0;
  for (size_t k = bytes.size(); k-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[k]);
  return value;
}

// The kind of file that these bytes begin, if it is not text that we read: "a gzip archive", "UTF-16 text" ...; else
// empty.
std::string_view kind_of(std::string_view bytes);

// In quotes, with unprintable bytes as \x.., truncated if long.
std::string in_quotes(std::string_view text);

}  // namespace spherepair
