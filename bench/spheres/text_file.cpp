// SPDX-License-Identifier: MIT
// Reads spheres from lines of text, a sphere each: columns separated by blanks, or all by commas or semicolons. The
// columns are those of --columns; or of a first line of names; or x y z, x y z radius, or these with vx vy vz.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "bench/io/file_lines.h"
#include "bench/io/numbers.h"
#include "bench/spheres/sphere_file.h"

namespace spherepair {
namespace {

constexpr size_t most_columns = 1000;

// Without quotes and in lower case: "X" is x, and r a radius.
std::string plain_name(std::string_view field) {
  std::string name(field);
  std::erase(name, '"');
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return name == "r" ? "radius" : name;
}

std::string_view unquoted(std::string_view field) {
  const bool quoted = field.size() > 1 && field.starts_with('"') && field.ends_with('"');
  return quoted ? field.substr(1, field.size() - 2) : field;
}

class TextReader {
 public:
  TextReader(const FileBytes& file, const SphereFileOptions& options) : file_(file) {
    if (!options.columns.empty()) columns_ = columns_of_names("--columns", options.columns);
  }

  // Takes a line; false for one without a sphere: empty, a comment, or names.
  bool take(uint64_t line, std::string_view text) {
    split_separated_fields(text.substr(0, text.find('#')), most_columns, fields_);
    if (fields_.empty()) return false;
    std::ranges::transform(fields_, fields_.begin(), unquoted);
    if (columns_.count == 0 && !choose_columns(line, text)) return false;
    if (by_place_ && columns_.count != 3 && (fields_.size() == 4 || fields_.size() == 7)) columns_by_place();
    if (fields_.size() != columns_.count)
      file_.fail_at_line(line, fmt::format("{} columns ({})", columns_.count, columns_.text),
                         fmt::format("{}: {}", fields_.size(), in_quotes(text)));
    return true;
  }
  Decimal number(uint64_t line, Quantity quantity) const {
    return read_number(file_, line, fields_, columns_, quantity);
  }
  const Columns& columns() const { return columns_; }

 private:
  // False if the line holds their names.
  bool choose_columns(uint64_t line, std::string_view text) {
    const auto is_number = [](std::string_view field) { return parse_decimal(field).has_value(); };
    if (!is_number(fields_[0])) {
      std::vector<std::string> names;
      for (const std::string_view field : fields_) names.push_back(plain_name(field));
      if (std::ranges::count(names, "x") == 0 && std::ranges::any_of(fields_, is_number))
        file_.fail_at_line(
            line, "numbers, or names of columns with x, y and z; others need --columns, such as --columns _,x,y,z",
            in_quotes(text));
      columns_ = columns_of_names(fmt::format("{}, line {}, read as names of columns", file_.name(), line), names);
      return false;
    }
    if (std::ranges::any_of(fields_, [](auto field) { return field.find_first_of(" \t") != field.npos; }))
      file_.fail_at_line(line, "columns separated by blanks, commas or semicolons alone, and decimal points",
                         in_quotes(text));
    const size_t count = fields_.size();
    if (count != 3 && count != 4 && count != 7)
      file_.fail_at_line(line, "3 columns (x y z), 4 (and radius) or 7 (and vx vy vz); others need --columns",
                         fmt::to_string(count));
    by_place_ = true;
    columns_by_place();
    return true;
  }
  // Lines with and without a velocity may stand in one file.
  void columns_by_place() {
    if (columns_.count == fields_.size()) return;
    const auto names = std::span(quantity_names).first(fields_.size());
    columns_ = columns_of_names("", std::vector<std::string>(names.begin(), names.end()));
  }

  const FileBytes& file_;
  Columns columns_;
  bool by_place_ = false;
  std::vector<std::string_view> fields_;
};

}  // namespace

SphereFile read_text(const FileBytes& file, const SphereFileOptions& options, SphereRows& rows) {
  require_text(file);
  if (options.frame)
    throw std::invalid_argument(
        fmt::format("{} is text with one frame, and --frame is for XYZ files only", file.name()));
  SphereFile input;
  TextReader reader(file, options);
  for (FileLines lines = lines_of(file); !lines.at_end();) {
    const uint64_t line = lines.line, sphere = rows.positions.size();
    if (!reader.take(line, lines.next())) continue;
    if (sphere == kMostSpheres) file.fail_at_line(line, fmt::format("at most {} spheres", kMostSpheres), "another");
    rows.add(options.radius.value_or(0));
    for (size_t quantity = 0; quantity < quantity_names.size(); ++quantity) {
      if (!reader.columns().has(Quantity(quantity))) continue;
      const Decimal number = reader.number(line, Quantity(quantity));
      ++input.values;
      input.changed += number.changed;
      rows.set(sphere, Quantity(quantity), number);
    }
  }
  if (rows.positions.empty())
    throw std::invalid_argument(fmt::format("{} holds no sphere: expected lines of x y z radius", file.name()));
  input.own_radii = reader.columns().has(QUANTITY_RADIUS);
  check_radius(file, input.own_radii, options);
  input.format = fmt::format("text ({})", reader.columns().text);
  return input;
}

}  // namespace spherepair
