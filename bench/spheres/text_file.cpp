// SPDX-License-Identifier: MIT
// Reads spheres from lines of text, a sphere each. Columns are separated by blanks, or all by commas or semicolons, and
// every line has the same number. Their meaning comes from --columns, or from names in the first line or a comment;
// else they are x y z, x y z radius, or these with vx vy vz.
#include <fmt/format.h>

#include <algorithm>

#include "bench/io/file_lines.h"
#include "bench/io/numbers.h"
#include "bench/spheres/column_comment.h"
#include "bench/spheres/columns.h"
#include "bench/spheres/sphere_file.h"
#include "bench/spheres/xyz_columns.h"
#include "bench/text/fields.h"

namespace spherepair {
namespace {

using Names = std::vector<NamedColumn>;

Names named(std::span<const std::string> words) {
  Names names;
  for (const std::string& word : words) names.push_back({word});
  return names;
}

struct SeenComment {
  uint64_t line = 0;
  std::string text = {};
  ColumnComment columns = {};
};

class TextReader {
 public:
  TextReader(const FileBytes& file, const SphereFileOptions& options) : file_(file), options_(options) {
    if (file.name().ends_with(".tsv")) separator_ = '\t';
  }

  // Reads a line into another row, unless it is empty, a comment, or names.
  void read(uint64_t line, std::string_view text, SphereRows& rows) {
    const std::string_view content = without_comment(text);
    if (trimmed(content).empty()) {
      if (!columns_) take_comment(line, trimmed(text));
      return;
    }
    if (!columns_ && separator_ != '\t') separator_ = separator_of(content, options_.decimal_comma);
    split_line(content, separator_, fields_);
    if (!columns_ && !choose_columns(line, content)) return;
    if (rows.positions.size() == kMostSpheres)
      file_.fail_at_line(line, fmt::format("at most {} spheres", kMostSpheres), "another");
    rows.add(options_.radius.value_or(0));
    reader_->read(line, text, fields_, rows.positions.size() - 1, rows);
    if (by_order_ && fields_.size() == 7) look_for_colours();
  }

  // Call this after the last line. Throws for ambiguous columns.
  const Columns& columns() const {
    if (!columns_)
      throw std::invalid_argument(fmt::format("{} holds no sphere: expected lines of x y z radius", file_.name()));
    if (may_be_colours_ && bright_)
      file_.fail_at_line(
          first_line_,
          "--columns: the last three of seven numbers may be colours; give --columns x,y,z,radius,vx,vy,vz or, if "
          "they are, --columns x,y,z,_,_,_,_",
          "seven numbers, the last three whole and from 0 to 255 in every line");
    return *columns_;
  }
  uint64_t changed() const { return reader_->changed(); }
  const std::string& box() const { return box_; }
  bool unused_radii() const { return unused_radii_; }

 private:
  bool is_number(std::string_view field) const { return parse_decimal(field, options_.decimal_comma).has_value(); }

  // A comment before the first sphere may hold the names of the columns, as np.savetxt writes them, or name a box.
  void take_comment(uint64_t line, std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of("# \t"), text.size()));
    if (box_.empty() && mentions_box(text)) box_ = text;
    ColumnComment columns = column_comment(text);
    if (!columns.names.empty() || !columns.order.empty())
      comments_.push_back({line, std::string(text), std::move(columns)});
  }

  // The last comment that names this number of columns; null without one.
  const SeenComment* naming_comment() const {
    const auto names_them = [&](const SeenComment& each) { return each.columns.names_columns(fields_.size()); };
    const auto found = std::find_if(comments_.rbegin(), comments_.rend(), names_them);
    return found == comments_.rend() ? nullptr : &*found;
  }
  // The names in the file for x=NAME of --columns, also those without x, y and z.
  Names names_for_option() const {
    if (!header_.empty()) return header_;
    if (const SeenComment* naming = naming_comment()) return naming->columns.names;
    for (const SeenComment& each : comments_)
      if (each.columns.names.size() == fields_.size()) return each.columns.names;
    return {};
  }

  // Chooses the columns by the first line that is not a comment; false if that line has the names of the columns.
  bool choose_columns(uint64_t line, std::string_view text) {
    const bool numbers = std::ranges::any_of(fields_, [&](std::string_view field) { return is_number(field); });
    if (!numbers && header_.empty()) {
      if (separator_ == ' ' && text.find('\t') != text.npos) separator_ = '\t';
      header_ = named(names_in(text, separator_));
      names_line_ = line;
      if (options_.columns.empty()) take_names(header_, "read as names of columns");
      return false;
    }
    first_line_ = line;
    if (!options_.columns.empty()) {
      take(columns_of_option(options_.columns, names_for_option(), file_.name()));
    } else if (!header_.empty()) {
      take(columns_of_header_);
    } else if (const SeenComment* naming = naming_comment()) {
      names_line_ = naming->line;
      take_names(naming->columns.names, "a comment read as names of columns");
      take(columns_of_header_);
    } else {
      for (const SeenComment& each : comments_)
        if (!each.columns.agrees_with_order(fields_.size()))
          file_.fail_at_line(each.line,
                             fmt::format("a name in this comment for each of the {} columns, or no other order than x "
                                         "y z radius; say by --columns what they are, such as --columns x,y,z{}",
                                         fields_.size(), fields_.size() > 3 ? ",radius" : ""),
                             in_quotes(each.text));
      take_order(line, text);
    }
    return true;
  }
  void take_names(const Names& names, const char* how) {
    columns_of_header_ = columns_of_names(fmt::format("{}, line {}, {}", file_.name(), names_line_, how), names);
    columns_of_header_.by = fmt::format("by the names in line {}", names_line_);
  }
  void take_order(uint64_t line, std::string_view text) {
    if (!is_number(fields_[0]) && fields_[0].find_first_of("0123456789") == 0)
      file_.fail_at_line(line, "a number in column 1, or names of columns", in_quotes(fields_[0]));
    if (!is_number(fields_[0]))
      file_.fail_at_line(
          line, "numbers, or names of columns with x, y and z; others need --columns, such as --columns _,x,y,z",
          in_quotes(text));
    if (std::ranges::any_of(fields_, [](auto field) { return field.find_first_of(" \t") != field.npos; }))
      file_.fail_at_line(line,
                         "columns separated by blanks, commas or semicolons alone, and decimal points (or give "
                         "--decimal-comma)",
                         in_quotes(text));
    const size_t count = fields_.size();
    if (count != 3 && count != 4 && count != 7)
      file_.fail_at_line(line, "3 columns (x y z), 4 (and radius) or 7 (and vx vy vz); others need --columns",
                         fmt::to_string(count));
    by_order_ = true;
    take(columns_by_order(count));
    columns_->by = fmt::format("by the number of columns in line {}", line);
  }
  void take(const Columns& columns) {
    columns_ = columns;
    unused_radii_ = take_radii_away(*columns_, options_);
    reader_.emplace(file_, *columns_, options_.decimal_comma);
  }

  // Notes whether a line's last three numbers may be colours: scanners write x y z intensity r g b. Colours of 0 and 1
  // only would all be black.
  void look_for_colours() {
    for (const std::string_view field : std::span(fields_).last(3)) {
      const auto whole = whole_number_of(field, 0, 255);
      may_be_colours_ = may_be_colours_ && whole;
      bright_ = bright_ || whole.value_or(0) > 1;
    }
  }

  const FileBytes& file_;
  const SphereFileOptions& options_;
  char separator_ = ' ';
  Names header_;
  std::vector<SeenComment> comments_;
  uint64_t names_line_ = 0, first_line_ = 0;
  Columns columns_of_header_;
  std::optional<Columns> columns_;
  std::optional<RowReader> reader_;
  bool unused_radii_ = false, by_order_ = false, may_be_colours_ = true, bright_ = false;
  std::string box_;
  std::vector<std::string_view> fields_;
};

}  // namespace

SphereFile read_text(const FileBytes& file, const SphereFileOptions& options, SphereRows& rows) {
  require_text(file);
  TextReader reader(file, options);
  for (FileLines lines = lines_of(file); !lines.at_end();) {
    const uint64_t line = lines.line;
    reader.read(line, lines.next(), rows);
  }
  SphereFile input;
  const Columns& columns = reader.columns();
  input.values = rows.positions.size() * columns.quantities();
  input.changed = reader.changed();
  input.unread_box = reader.box();
  input.unused_radii = reader.unused_radii();
  input.own_radii = columns.has(QUANTITY_RADIUS);
  input.units = columns.units;
  check_radius(file, columns, options);
  input.format = fmt::format("text ({}): {}", columns.text, describe(columns));
  return input;
}

}  // namespace spherepair
