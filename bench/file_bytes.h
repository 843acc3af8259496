// SPDX-License-Identifier: MIT
// A file's bytes to read from, and errors that say where in it what was found.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace spherepair {

// Mapped into memory, or read whole where that is not possible (a pipe). Throws std::invalid_argument.
class FileBytes {
 public:
  explicit FileBytes(const std::filesystem::path& path);
  ~FileBytes();
  FileBytes(const FileBytes&) = delete;
  FileBytes& operator=(const FileBytes&) = delete;

  const std::string& name() const { return name_; }
  std::string_view bytes() const { return bytes_; }

  // Throw std::invalid_argument: FILE, line 7: expected ..., found ...
  [[noreturn]] void fail_at_line(uint64_t line, std::string_view expected, std::string_view found) const;
  [[noreturn]] void fail_at_byte(uint64_t offset, std::string_view expected, std::string_view found) const;

 private:
  void read_whole(int descriptor);

  std::string name_, buffer_;
  std::string_view bytes_;
  bool mapped_ = false;
};

// In quotes, with unprintable bytes as \x.. and the end left out when it is long.
std::string in_quotes(std::string_view text);

}  // namespace spherepair
