// SPDX-License-Identifier: MIT
// The lines of a text file.
#pragma once

#include <algorithm>

#include "common/files/file_bytes.h"

namespace spherepair {

// The unread rest of a file.
struct FileLines {
  std::string_view rest;
  uint64_t line = 1;  // number of its first line

  bool at_end() const { return rest.empty(); }

  std::string_view next() {
    const size_t end = std::min(rest.find('\n'), rest.size());
    std::string_view text = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    ++line;
    if (text.ends_with('\r')) text.remove_suffix(1);
    return text;
  }

  void skip_blank_lines() {
    for (FileLines ahead = *this; !ahead.at_end() && ahead.next().find_first_not_of(" \t") == rest.npos;) *this = ahead;
  }
};

// The lines of a whole file, after its byte order mark (UTF-8) if it has one.
inline FileLines lines_of(const FileBytes& file) {
  std::string_view bytes = file.bytes();
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
  return {bytes};
}

// Throws std::invalid_argument for a file of another kind, and at the first NUL byte, with its line: the file is
// damaged or not text.
inline void require_text(const FileBytes& file) {
  const std::string_view bytes = file.bytes(), kind = kind_of(bytes);
  if (!kind.empty()) file.fail_at_line(1, "text (ASCII or UTF-8)", kind);
  const size_t nul = bytes.find('\0');
  if (nul == bytes.npos) return;
  const auto lines_before = std::ranges::count(bytes.substr(0, nul), '\n');
  file.fail_at_line(uint64_t(lines_before) + 1, "text", "a NUL byte");
}

}  // namespace spherepair
