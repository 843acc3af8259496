// SPDX-License-Identifier: MIT
// Text tables, formatted numbers, and progress for a terminal.
#pragma once

#include <chrono>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace spherepair {

using json = nlohmann::ordered_json;

// Indented, and on one line. Bytes that are not UTF-8 become replacement characters.
std::string json_text(const json& value);
std::string json_line(const json& value);

// Converts each entry by its to_json.
template <typename Entry>
json list_of(const std::vector<Entry>& entries) {
  json list = json::array();
  for (const Entry& entry : entries) list.push_back(to_json(entry));
  return list;
}

struct Column {
  std::string group;  // heading over neighbouring columns of the same group; may be empty
  std::string name, unit;
  bool left = false;
};

// Marks a cell whose time decides nothing. Tables with such a cell have a note.
constexpr const char* unsteady_mark = " !";

// Widths of a terminal and of a file with tables: tables are split and sentences wrapped to fit.
constexpr size_t kTextWidth = 80, kFileWidth = 132;

// Cells are text, so that a column can hold numbers and "skipped"; "-" and an empty cell mean no value. Brackets mean
// 95 % intervals, which a note below the table says.
struct Table {
  std::string title;
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> notes;
  bool only_in_csv = false;  // too long to read

  // The table as text, without columns that have no value in any row, split into parts if it is wider than this.
  std::string text(size_t width = kTextWidth) const;
  json to_json() const;

 private:
  std::vector<std::string> all_notes() const;
};

std::string format_ms(double seconds);       // milliseconds, four significant digits
std::string format_us(double seconds);       // microseconds
std::string format_number(double value);     // four significant digits
std::string format_rate(double per_second);  // 3.13e+12

std::string hex64(uint64_t value);

// Wraps a text to lines of at most this width. The first line begins with `first`, the others with `next`.
std::string wrapped(const std::string& text, const std::string& first = "", const std::string& next = "",
                    size_t width = kTextWidth);

// One line on standard error that overwrites itself; silent if that is not a terminal.
class Progress {
 public:
  explicit Progress(bool shown = true);
  ~Progress() { clear(); }
  void say(const std::string& what);
  void clear();
  bool due() const;  // whether to print: on a terminal, and not within 0.2 s of the last line; for loops of short steps

  // Sets the prefix of the next lines: the parts done and the estimated time of the rest.
  void reach(uint64_t done, uint64_t total);

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::string reached_;
  std::chrono::steady_clock::time_point said_ = start_;
  bool terminal_;
  size_t shown_ = 0;
};

}  // namespace spherepair
