// SPDX-License-Identifier: MIT
#include "bench/spheres/xyz_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "bench/io/numbers.h"
#include "bench/spheres/columns.h"
#include "bench/spheres/frames.h"
#include "bench/text/fields.h"

namespace spherepair {
namespace {

// Finds one of the keys in upper or lower case: programs write Lattice and lattice. Throws for a key with an unfinished
// value, and for a repeated key.
const CommentPair* find_pair(const Comment& comment, std::span<const std::string_view> keys) {
  const CommentPair* found = nullptr;
  for (const CommentPair& pair : comment.pairs) {
    if (!pair.value || std::ranges::count(keys, lower_case(pair.key)) == 0) continue;
    if (!pair.complete)
      comment.file.fail_at_line(comment.line, fmt::format("a value of {} whose quotes or brackets end", pair.key),
                                in_quotes(comment.text));
    if (found && found->value != pair.value)
      comment.file.fail_at_line(comment.line, fmt::format("{} once", pair.key), in_quotes(comment.text));
    found = &pair;
  }
  return found;
}
const CommentPair* find_pair(const Comment& comment, std::string_view key) { return find_pair(comment, {&key, 1}); }

struct Property {
  std::string name, type;
  size_t columns = 0;
};

std::optional<Property> property_of(const std::string& name, const std::string& type, const std::string& columns) {
  const auto count = whole_number_of(columns, 1, 1000);
  if (name.empty() || !count || (type != "S" && type != "R" && type != "I" && type != "L")) return std::nullopt;
  return Property{name, type, *count};
}

std::vector<std::string> split_at_colons(std::string_view text) {
  std::vector<std::string> parts;
  std::istringstream stream{std::string(text)};
  for (std::string part; std::getline(stream, part, ':');) parts.push_back(part);
  return parts;
}

// The words between blanks, commas, brackets and quotes: T, T and F of pbc = "T T F", [T, T, F] or [[T], [T], [F]].
std::vector<std::string> words_of(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return std::string_view(",[]{}\"\t").find(c) != std::string_view::npos; }, ' ');
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

// The numbers of a text that has `count` of them and nothing else.
std::optional<std::vector<double>> numbers_of(const std::string& text, size_t count) {
  std::vector<double> numbers;
  for (const std::string& word : words_of(text)) {
    const auto number = parse_decimal(word);
    if (!number || !std::isfinite(number->rounded)) return std::nullopt;
    numbers.push_back(number->value);
  }
  return numbers.size() == count ? std::optional(numbers) : std::nullopt;
}

// Whether this is a box of i-PI: # CELL(abcABC): 10 10 10 90 90 90.
bool is_cell_of_ipi(const CommentPair& pair) { return lower_case(pair.key).starts_with("cell("); }

std::optional<ListBox> box_of(const CommentPair* cell, const std::vector<std::optional<bool>>& axes) {
  if (!cell || lower_case(cell->key) != "lattice" || !cell->value) return std::nullopt;
  const auto numbers = numbers_of(*cell->value, 9);
  if (!numbers) return std::nullopt;
  ListBox box;
  for (size_t k = 0; k < 9; ++k) box.rows[k / 3][k % 3] = (*numbers)[k];
  for (size_t k = 0; k < 3; ++k) box.periodic[k] = axes.empty() || *axes[k];
  return box;
}

}  // namespace

std::optional<std::vector<NamedColumn>> properties_of(const Comment& comment, bool by_names) {
  const CommentPair* pair = find_pair(comment, "properties");
  if (!pair) return std::nullopt;
  const std::vector<std::string> parts = split_at_colons(*pair->value);
  const auto fail = [&](std::string_view expected) {
    comment.file.fail_at_line(comment.line, expected, in_quotes(*pair->value));
  };
  if (parts.empty() || parts.size() % 3) fail("Properties=name:type:columns, repeated, such as species:S:1:pos:R:3");
  std::vector<NamedColumn> names;
  std::vector<Property> wrong;
  bool triples[2] = {};  // whether positions, velocities are one name of three columns
  for (size_t k = 0; k < parts.size(); k += 3) {
    const auto property = property_of(parts[k], parts[k + 1], parts[k + 2]);
    if (!property) fail("Properties with a name, a type S, R, I or L and a number of columns each");
    const KnownName* known = known_name(property->name);
    const bool number = property->type == "R" || property->type == "I";
    if (known && (!number || property->columns != known->count))
      wrong.push_back(*property);
    else if (known && known->count == 3)
      triples[known->first >= QUANTITY_VX] = true;
    names.push_back({property->name, property->columns});
  }
  for (const Property& property : wrong) {
    const KnownName* known = known_name(property.name);
    const bool beside_triple =
        known->count == 1 && known->first != QUANTITY_RADIUS && triples[known->first >= QUANTITY_VX];
    if (by_names && !beside_triple)
      fail("Properties with pos:R:3 once, and radius:R:1 and velo:R:3 once at most, or --columns");
  }
  return names;
}

Columns columns_of_properties(const Comment& comment, std::span<const NamedColumn> properties) {
  const std::string value = in_quotes(*find_pair(comment, "properties")->value);
  Columns columns = columns_of_names(fmt::format("{}, line {}: expected Properties with pos:R:3 once, found {}",
                                                 comment.file.name(), comment.line, value),
                                     properties);
  columns.text = value;
  columns.by = fmt::format("by Properties in line {}", comment.line);
  return columns;
}

Columns classic_columns(const FileBytes& file, uint64_t line, std::string_view text, bool types) {
  std::vector<std::string_view> fields;
  split_fields(text, 100, fields);
  const size_t species = !fields.empty() && (types || !parse_decimal(fields[0])) ? 1 : 0;
  if (fields.size() < species + 3 || fields.size() > species + 4)
    file.fail_at_line(line,
                      species ? "4 columns, species x y z, or 5 with a radius; others need Properties= in line 2, or "
                                "--columns"
                              : "3 columns, x y z, or 4 with a radius; others need Properties= in line 2, or --columns",
                      fmt::format("{}: {}", fields.size(), in_quotes(text)));
  std::vector<NamedColumn> names = {{"x"}, {"y"}, {"z"}};
  if (species) names.insert(names.begin(), {"species"});
  if (fields.size() == species + 4) names.push_back({"radius"});
  Columns columns = columns_of_names(file.name(), names);
  columns.by_order = true;
  columns.by = types ? "the first of four whole in every line: a type, since --radius gives the radii"
                     : fmt::format("by the number of columns in line {}", line);
  return columns;
}

PeriodicBox periodic_box(const Comment& comment) {
  constexpr std::string_view cells[] = {"lattice", "cell", "box", "unitcell", "unit_cell"};
  const CommentPair *cell = find_pair(comment, cells), *pbc = find_pair(comment, "pbc");
  std::vector<std::optional<bool>> axes;
  if (pbc)
    for (const std::string& word : words_of(*pbc->value)) axes.push_back(parse_boolean(word));
  if (pbc && (axes.size() != 3 || !std::ranges::all_of(axes, [](const auto& axis) { return axis.has_value(); })))
    comment.file.fail_at_line(comment.line, "pbc with T or F for each of the three axes, such as pbc=\"T T F\"",
                              in_quotes(*pbc->value));
  if (pbc && std::ranges::none_of(axes, [](const auto& axis) { return *axis; })) return {};
  std::string text;
  if (cell)
    text = fmt::format("{}={}", lower_case(cell->key) == "lattice" ? "Lattice" : lower_case(cell->key),
                       in_quotes(*cell->value));
  if (pbc) text += fmt::format("{}pbc={}", cell ? " " : "", in_quotes(*pbc->value));
  if (text.empty() && std::ranges::any_of(comment.pairs, is_cell_of_ipi)) text = in_quotes(comment.text);
  return {.text = text,
          .box = box_of(cell, axes),
          .mention = text.empty() && mentions_box(comment.text) ? std::string(comment.text) : ""};
}

std::optional<Point3> origin_of(const Comment& comment) {
  const CommentPair* given = find_pair(comment, "origin");
  if (!given) return Point3{};
  const auto numbers = numbers_of(*given->value, 3);
  return numbers ? std::optional(Point3{(*numbers)[0], (*numbers)[1], (*numbers)[2]}) : std::nullopt;
}

std::optional<WallBox> closed_box(const Comment& comment) {
  const CommentPair *lattice = find_pair(comment, "lattice"), *pbc = find_pair(comment, "pbc");
  if (!lattice || !pbc || !periodic_box(comment).text.empty()) return std::nullopt;
  const auto box = box_of(lattice, std::vector<std::optional<bool>>(3, false));
  const auto origin = origin_of(comment);
  return box && origin ? box_along_axes(*box, *origin) : std::nullopt;
}

}  // namespace spherepair
