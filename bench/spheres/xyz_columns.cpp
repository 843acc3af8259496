// SPDX-License-Identifier: MIT
#include "bench/spheres/xyz_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "bench/io/numbers.h"

namespace spherepair {
namespace {

constexpr std::string_view blank = " \t";

// Reads up to `stop` or a blank; quotes and brackets around a value may hold both.
std::string_view take_word(std::string_view& text, std::string_view stop) {
  const std::string_view open = "\"'{[", close = "\"'}]";
  const size_t kind = text.empty() ? open.npos : open.find(text.front());
  const size_t end = kind == open.npos ? open.npos : text.find(close[kind], 1);
  const bool enclosed = end != text.npos;
  const size_t size = enclosed ? end + 1 : std::min(text.find_first_of(stop), text.size());
  const std::string_view word = enclosed ? text.substr(1, size - 2) : text.substr(0, size);
  text.remove_prefix(size);
  return word;
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; }

// Whatever the case of its letters: programs write Lattice and lattice.
std::optional<std::string_view> value_of_key(std::string_view comment, std::string_view wanted) {
  while (true) {
    comment.remove_prefix(std::min(comment.find_first_not_of(blank), comment.size()));
    if (comment.empty()) return std::nullopt;
    const std::string_view key = take_word(comment, "= \t");
    if (!comment.starts_with('=')) continue;
    comment.remove_prefix(1);
    const std::string_view value = take_word(comment, blank);
    if (std::ranges::equal(key, wanted, {}, lower, lower)) return value;
  }
}

std::vector<std::string> split_at_colons(std::string_view text) {
  std::vector<std::string> parts;
  std::istringstream stream{std::string(text)};
  for (std::string part; std::getline(stream, part, ':');) parts.push_back(part);
  return parts;
}

// Quantities by the names that programs give them.
struct KnownProperty {
  std::string_view name;
  Quantity first;
  size_t columns;
};
constexpr KnownProperty known_properties[] = {
    {"pos", QUANTITY_X, 3},  {"radius", QUANTITY_RADIUS, 1}, {"radii", QUANTITY_RADIUS, 1}, {"velo", QUANTITY_VX, 3},
    {"vel", QUANTITY_VX, 3}, {"velocity", QUANTITY_VX, 3},   {"velocities", QUANTITY_VX, 3}};

struct Property {
  std::string name, type;
  size_t columns = 0;
};

std::optional<Property> property_of(const std::string& name, const std::string& type, const std::string& columns) {
  const auto count = whole_number_of(columns, 1, 1000);
  if (name.empty() || !count || (type != "S" && type != "R" && type != "I" && type != "L")) return std::nullopt;
  return Property{name, type, *count};
}

}  // namespace

std::optional<Columns> named_columns(const FileBytes& file, uint64_t line, std::string_view comment) {
  const auto value = value_of_key(comment, "Properties");
  if (!value) return std::nullopt;
  const std::vector<std::string> parts = split_at_colons(*value);
  const auto fail = [&](std::string_view expected) { file.fail_at_line(line, expected, in_quotes(*value)); };
  if (parts.empty() || parts.size() % 3) fail("Properties=name:type:columns, repeated, such as species:S:1:pos:R:3");
  Columns columns{.text = in_quotes(*value)};
  for (size_t k = 0; k < parts.size(); k += 3) {
    const auto property = property_of(parts[k], parts[k + 1], parts[k + 2]);
    if (!property) fail("Properties with a name, a type S, R, I or L and a number of columns each");
    const auto known = std::ranges::find(known_properties, property->name, &KnownProperty::name);
    if (known != std::end(known_properties)) {
      const bool number = property->type == "R" || property->type == "I";
      if (columns.has(known->first) || !number || property->columns != known->columns)
        fail("Properties with pos:R:3 once, and radius:R:1 and velo:R:3 once at most");
      for (size_t c = 0; c < known->columns; ++c) columns.columns[known->first + c] = columns.count + c;
    }
    if (property->name == "species" && property->columns == 1 && !columns.species) columns.species = columns.count;
    columns.momenta = columns.momenta || property->name == "momenta";
    columns.count += property->columns;
  }
  if (!columns.has(QUANTITY_X)) fail("Properties with pos:R:3");
  return columns;
}

Columns classic_columns(const FileBytes& file, uint64_t line, std::string_view text) {
  std::vector<std::string_view> fields;
  split_fields(text, 100, fields);
  const size_t species = fields.empty() || parse_decimal(fields[0]) ? 0 : 1;
  if (fields.size() < species + 3 || fields.size() > species + 4)
    file.fail_at_line(line,
                      species ? "4 columns, species x y z, or 5 with a radius; others need Properties= in line 2"
                              : "3 columns, x y z, or 4 with a radius; others need Properties= in line 2",
                      fmt::format("{}: {}", fields.size(), in_quotes(text)));
  std::vector<std::string> names = {"x", "y", "z"};
  if (species) names.insert(names.begin(), "species");
  if (fields.size() == species + 4) names.push_back("radius");
  Columns columns = columns_of_names(file.name(), names);
  if (species) columns.species = 0;
  return columns;
}

std::string periodic_box(const FileBytes& file, uint64_t line, std::string_view comment) {
  const auto lattice = value_of_key(comment, "Lattice"), cell = lattice ? lattice : value_of_key(comment, "cell");
  const auto pbc = value_of_key(comment, "pbc");
  std::vector<std::string_view> axes;
  if (pbc) split_separated_fields(*pbc, 4, axes);
  const auto is = [](const std::vector<std::string>& words) {
    return [=](std::string_view axis) { return std::ranges::count(words, std::string(axis)) > 0; };
  };
  const auto periodic = is({"T", "True", "true", "1"}), open = is({"F", "False", "false", "0"});
  if (pbc && (axes.size() != 3 || !std::ranges::all_of(axes, [&](auto a) { return periodic(a) || open(a); })))
    file.fail_at_line(line, "pbc with T or F for each of the three axes, such as pbc=\"T T F\"", in_quotes(*pbc));
  if (pbc ? std::ranges::none_of(axes, periodic) : !cell) return "";
  std::string box;
  if (cell) box += fmt::format("{}={}", lattice ? "Lattice" : "cell", in_quotes(*cell));
  if (pbc) box += fmt::format("{}pbc={}", cell ? " " : "", in_quotes(*pbc));
  return box;
}

}  // namespace spherepair
