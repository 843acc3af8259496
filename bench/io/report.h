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

// Ends a cell whose time decides nothing; a table with one has a note that says so.
constexpr const char* unsteady_mark = " !";

// Columns of a terminal and of a file that has tables: tables are split, and sentences wrapped, to stay within.
constexpr size_t kTextWidth = 80, kFileWidth = 132;

// Cells are text, so that a column can hold numbers and "skipped"; "-" and nothing stand for no value. Brackets are
// kept for 95 % intervals: a table with one has a note that says so.
struct Table {
  std::string title;
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> notes;
  bool only_in_csv = false;  // too long for people

  // Without the columns that have no value in any row; in parts, where it is wider than this.
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

// The words of a text in lines of at most this width, the first behind `first` and the others behind `next`.
std::string wrapped(const std::string& text, const std::string& first = "", const std::string& next = "",
                    size_t width = kTextWidth);

// One line on standard error that overwrites itself; silent if that is not a terminal.
class Progress {
 public:
  explicit Progress(bool shown = true);
  ~Progress() { clear(); }
  void say(const std::string& what);
  void clear();
  bool due() const;  // on a terminal, and nothing was said for 0.2 s: for loops of short steps

  // Prefix of the following lines: parts done and the estimated time of the others.
  void reach(uint64_t done, uint64_t total);

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::string reached_;
  std::chrono::steady_clock::time_point said_ = start_;
  bool terminal_;
  size_t shown_ = 0;
};

}  // namespace spherepair
