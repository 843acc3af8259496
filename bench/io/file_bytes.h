// SPDX-License-Identifier: MIT
// A file's bytes to read from, and errors that say where in it what was found.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace spherepair {

// Read whole and not mapped into memory, since a process that reads a mapped file which another shortens is ended.
// Throws std::invalid_argument, or BackendError where memory has no room for the file.
class FileBytes {
 public:
  explicit FileBytes(const std::filesystem::path& path);

  const std::string& name() const { return name_; }
  std::string_view bytes() const { return bytes_; }

  // Throw std::invalid_argument: FILE, line 7: expected ..., found ...
  [[noreturn]] void fail_at_line(uint64_t line, std::string_view expected, std::string_view found) const;
  [[noreturn]] void fail_at_byte(uint64_t offset, std::string_view expected, std::string_view found) const;

 private:
  std::string name_, bytes_;
};

// In quotes, with unprintable bytes as \x.. and the end left out when it is long.
std::string in_quotes(std::string_view text);

}  // namespace spherepair
