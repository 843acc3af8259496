// SPDX-License-Identifier: MIT
#include "bench/io/report.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace spherepair {
namespace {

constexpr const char* kGap = "  ";

std::string pad(const std::string& text, size_t width, bool left) {
  return left ? fmt::format("{:<{}}", text, width) : fmt::format("{:>{}}", text, width);
}

std::vector<size_t> column_widths(const Table& table) {
  std::vector<size_t> widths;
  for (size_t c = 0; c < table.columns.size(); ++c) {
    size_t width = std::max(table.columns[c].name.size(), table.columns[c].unit.size());
    for (const auto& row : table.rows) width = std::max(width, row.at(c).size());
    widths.push_back(width);
  }
  return widths;
}

// Columns [first, last) share a group heading and are widened to fit it.
size_t group_end(const Table& table, size_t first) {
  size_t last = first + 1;
  const std::string& group = table.columns[first].group;
  while (last < table.columns.size() && !group.empty() && table.columns[last].group == group) ++last;
  return last;
}

size_t span_width(const std::vector<size_t>& widths, size_t first, size_t last) {
  size_t width = 2 * (last - first - 1);
  for (size_t c = first; c < last; ++c) width += widths[c];
  return width;
}

std::string trimmed(const std::string& line) { return line.substr(0, line.find_last_not_of(' ') + 1); }

std::string group_line(const Table& table, std::vector<size_t>& widths) {
  std::string line;
  bool any = false;
  for (size_t first = 0, last; first < table.columns.size(); first = last) {
    last = group_end(table, first);
    const std::string& group = table.columns[first].group;
    const size_t have = span_width(widths, first, last);
    for (size_t missing = have; missing < group.size(); ++missing) ++widths[first + missing % (last - first)];
    const size_t width = span_width(widths, first, last);
    line += (first ? kGap : "") + (group.empty() ? std::string(width, ' ') : fmt::format("{:-^{}}", group, width));
    any = any || !group.empty();
  }
  return any ? trimmed(line) + "\n" : "";
}

size_t width_of(const Table& table) {
  std::vector<size_t> widths = column_widths(table);
  group_line(table, widths);
  return span_width(widths, 0, widths.size());
}

// The table with these columns only.
Table part_of(const Table& table, const std::vector<size_t>& columns) {
  Table part;
  for (const size_t c : columns) part.columns.push_back(table.columns[c]);
  for (const auto& row : table.rows) {
    std::vector<std::string>& cells = part.rows.emplace_back();
    for (const size_t c : columns) cells.push_back(row.at(c));
  }
  return part;
}

bool is_value(const std::string& cell) { return !cell.empty() && cell != "-"; }

Table without_empty_columns(const Table& table) {
  std::vector<size_t> kept;
  for (size_t c = 0; c < table.columns.size(); ++c)
    if (table.rows.empty() || std::ranges::any_of(table.rows, [&](const auto& row) { return is_value(row.at(c)); }))
      kept.push_back(c);
  return part_of(table, kept);
}

// Splits the table into parts of at most this width. Each has the columns before the first group, which name its rows.
// Groups stay whole if they fit, and a part omits rows without a value in it. A table without groups is one part.
std::vector<Table> parts_of(const Table& table, size_t width) {
  std::vector<size_t> keys;
  while (keys.size() < table.columns.size() && table.columns[keys.size()].group.empty()) keys.push_back(keys.size());
  std::vector<size_t> part = keys;
  std::vector<Table> parts;
  const auto add = [&](size_t first, size_t last) {
    std::vector<size_t> longer = part;
    for (size_t c = first; c < last; ++c) longer.push_back(c);
    if (part.size() > keys.size() && width_of(part_of(table, longer)) > width) {
      parts.push_back(part_of(table, part));
      longer.erase(longer.begin() + ptrdiff_t(keys.size()), longer.begin() + ptrdiff_t(part.size()));
    }
    part = longer;
  };
  for (size_t first = keys.size(), last; first < table.columns.size(); first = last) {
    last = group_end(table, first);
    std::vector<size_t> alone = keys;
    for (size_t c = first; c < last; ++c) alone.push_back(c);
    const bool whole = width_of(part_of(table, alone)) <= width;
    for (size_t c = first; c < last; c = whole ? last : c + 1) add(c, whole ? last : c + 1);
  }
  parts.push_back(part_of(table, part));
  if (parts.size() == 1) return parts;
  const auto is_empty = [&](const auto& row) {
    return std::none_of(row.begin() + ptrdiff_t(keys.size()), row.end(), is_value);
  };
  for (Table& one : parts) std::erase_if(one.rows, is_empty);
  return parts;
}

// Heads and rows.
std::string grid_text(const Table& table) {
  std::vector<size_t> widths = column_widths(table);
  std::string out = group_line(table, widths);
  const auto line = [&](auto cell) {
    std::string text;
    for (size_t c = 0; c < widths.size(); ++c) text += (c ? kGap : "") + pad(cell(c), widths[c], table.columns[c].left);
    return trimmed(text) + "\n";
  };
  out += line([&](size_t c) { return table.columns[c].name; });
  const bool units = std::ranges::any_of(table.columns, [](const Column& column) { return !column.unit.empty(); });
  if (units) out += line([&](size_t c) { return table.columns[c].unit; });
  out += std::string(span_width(widths, 0, widths.size()), '-') + "\n";
  for (const auto& row : table.rows) out += line([&](size_t c) { return row[c]; });
  return out;
}

std::string significant(double value, const char* missing = "-") {
  if (!std::isfinite(value)) return missing;
  const double size = std::abs(value);
  if (size >= 1000) return fmt::format("{:.0f}", value);
  if (size >= 100) return fmt::format("{:.1f}", value);
  if (size >= 10) return fmt::format("{:.2f}", value);
  if (size >= 1) return fmt::format("{:.3f}", value);
  if (size >= 0.1 || size == 0) return fmt::format("{:.4f}", value);
  return fmt::format("{:.5f}", value);
}

}  // namespace

std::string json_text(const json& value) { return value.dump(1, ' ', false, json::error_handler_t::replace) + "\n"; }
std::string json_line(const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }

std::vector<std::string> Table::all_notes() const {
  std::vector<std::string> all = notes;
  const auto any_cell = [&](auto of_note) {
    return std::ranges::any_of(rows, [&](const auto& row) { return std::ranges::any_of(row, of_note); });
  };
  if (any_cell([](const std::string& cell) { return cell.find('[') != cell.npos; }))
    all.push_back("[low, high]: the 95 % interval of the median.");
  if (any_cell([](const std::string& cell) { return cell.ends_with(unsteady_mark); }))
    all.push_back("!: busy machine, or an interval wider than 2x; such a time decides nothing.");
  return all;
}

std::string Table::text(size_t width) const {
  std::string out = wrapped(title, "", "  ", width) + "\n";
  const std::vector<Table> parts = parts_of(without_empty_columns(*this), width);
  for (size_t k = 0; k < parts.size(); ++k) {
    if (k) out += '\n';
    out += grid_text(parts[k]);
  }
  for (const std::string& note : all_notes()) out += wrapped(note, "* ", "  ", width) + "\n";
  return out;
}

json Table::to_json() const {
  json heads = json::array();
  for (const Column& column : columns)
    heads.push_back({{"group", column.group}, {"name", column.name}, {"unit", column.unit}});
  return {{"title", title}, {"columns", heads}, {"rows", rows}, {"notes", all_notes()}};
}

std::string format_ms(double seconds) { return significant(seconds * 1e3); }
std::string format_us(double seconds) { return significant(seconds * 1e6); }
std::string format_number(double value) { return significant(value); }
std::string format_rate(double per_second) {
  return std::isfinite(per_second) ? fmt::format("{:.3g}", per_second) : "-";
}

std::string hex64(uint64_t value) { return fmt::format("{:016x}", value); }

std::string wrapped(const std::string& text, const std::string& first, const std::string& next, size_t width) {
  std::istringstream words(text);
  std::string line = first, out;
  bool empty = true;
  for (std::string word; words >> word; empty = false) {
    if (!empty && line.size() + 1 + word.size() > width) {
      out += line + "\n";
      line = next;
      empty = true;
    }
    line += (empty ? "" : " ") + word;
  }
  return out + line;
}

Progress::Progress(bool shown) : terminal_(shown && isatty(STDERR_FILENO) != 0) {}

void Progress::say(const std::string& what) {
  if (!terminal_) return;
  const std::string line = (reached_ + what).substr(0, kTextWidth - 1);
  fmt::print(stderr, "\r{:<{}}", line, std::max(shown_, line.size()));
  std::fflush(stderr);
  shown_ = line.size();
  said_ = std::chrono::steady_clock::now();
}

bool Progress::due() const {
  return terminal_ && std::chrono::steady_clock::now() - said_ > std::chrono::milliseconds(200);
}

void Progress::reach(uint64_t done, uint64_t total) {
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start_;
  reached_ = fmt::format("{} of {}", done, total);
  if (done) reached_ += fmt::format(", about {:.0f} s left", taken.count() * double(total - done) / double(done));
  reached_ += ": ";
}

void Progress::clear() {
  if (shown_ == 0) return;
  fmt::print(stderr, "\r{:{}}\r", "", shown_);
  std::fflush(stderr);
  shown_ = 0;
}

}  // namespace spherepair
