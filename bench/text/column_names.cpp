// SPDX-License-Identifier: MIT
#include "bench/text/column_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "bench/text/fields.h"
#include "bench/text/known_columns.h"
#include "common/files/file_bytes.h"
#include "common/scene/known_name.h"

namespace spherepair {
namespace {

constexpr std::string_view option_name = "--columns";

bool is_word_of_option(std::string_view word) {
  return std::ranges::count(quantity_names, word) || std::ranges::count(other_columns, word);
}

// Notes the unit of a column of lengths or velocities; all such columns must have the same unit.
void add_unit(const std::string& where, std::string& units, const NamedColumn& column, const std::string& unit) {
  if (!units.empty() && !unit.empty() && units != unit)
    throw std::invalid_argument(fmt::format("{}: the columns are in several units, {} and {}: {}; write all in one",
                                            where, units, unit, in_quotes(column.name)));
  if (units.empty()) units = unit;
}

// The column of the file with this name. If several names differ only in case and unit, takes the equal one.
size_t find_column(std::string_view wanted, std::span<const NamedColumn> names, const std::string& file) {
  const auto fail = [&](std::string_view what) {
    throw std::invalid_argument(
        fmt::format("--columns: {} '{}' in {}, whose columns are '{}'", what, wanted, file, all_names(names)));
  };
  size_t equal = 0, alike = 0, found = 0;
  for (size_t k = 0; k < names.size(); ++k) {
    const bool is_equal = trimmed(names[k].name) == wanted;
    const bool is_alike = plain_name(names[k].name).name == plain_name(wanted).name;
    if (is_equal || (is_alike && equal == 0)) found = k;
    equal += is_equal;
    alike += is_alike;
  }
  if (equal + alike == 0) fail("there is no column");
  if (equal > 1 || (equal == 0 && alike > 1)) fail("several columns are named");
  return found;
}

}  // namespace

size_t Columns::quantities() const {
  return size_t(std::ranges::count_if(columns, [](const auto& column) { return column.has_value(); }));
}

std::string all_names(std::span<const NamedColumn> names) {
  std::string words;
  for (const NamedColumn& column : names) {
    if (&column != names.data()) words += ' ';
    for (const char c : column.name)  // neither a terminal nor JSON takes all bytes
      words += c >= ' ' && c <= '~' ? std::string(1, c) : fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
  }
  return words;
}

Columns columns_of_names(const std::string& where, std::span<const NamedColumn> names) {
  const auto fail = [&](const std::string& why) { throw std::invalid_argument(where + ": " + why); };
  const bool in_file = where != option_name;
  Columns columns{.text = all_names(names)};
  for (const NamedColumn& column : names) {
    const std::string plain = plain_name(column.name).name;
    if (plain == "species" && column.count == 1 && !columns.species) columns.species = columns.count;
    columns.momenta = columns.momenta || plain == "momenta";
    columns.count += column.count;
  }
  const std::vector<Candidate> candidates = candidates_of(names);
  const auto remedy = [&] { return in_file ? advice(columns, candidates) : ""; };
  std::string velocity_units;
  for (const auto& [column, known, at, same_case, diameters] : candidates) {
    if (columns.has(known->first)) {
      if (known->first == QUANTITY_RADIUS && diameters != columns.diameters)
        fail("radius and diameter are both there" + remedy());
      fail(fmt::format("the column {} stands twice{}", quantity_names[known->first], remedy()));
    }
    columns.diameters = columns.diameters || diameters;
    for (size_t c = 0; c < known->count; ++c) columns.columns[known->first + c] = at + c;
    add_unit(where, known->first < QUANTITY_VX ? columns.units : velocity_units, column, plain_name(column.name).unit);
  }
  if (!columns.units.empty() && !velocity_units.empty() && !is_unit_per_time(velocity_units, columns.units))
    fail(fmt::format("lengths are in {} and velocities in {}: write both in one unit of length", columns.units,
                     velocity_units));
  if (!columns.has(QUANTITY_X) || !columns.has(QUANTITY_Y) || !columns.has(QUANTITY_Z)) {
    const bool triples = std::ranges::count(names, 3u, &NamedColumn::count) > 0;
    fail(fmt::format("the columns x, y and z must be among '{}'{}{}", columns.text,
                     in_file ? "; name them with --columns x=NAME,y=NAME,z=NAME" : "",
                     in_file && triples ? ", or pos=NAME for one of three columns" : ""));
  }
  if (columns.has(QUANTITY_VX) != columns.has(QUANTITY_VY) || columns.has(QUANTITY_VX) != columns.has(QUANTITY_VZ))
    fail(fmt::format("of the columns vx, vy and vz only some are among '{}'{}", columns.text, remedy()));
  return columns;
}

Columns columns_by_order(size_t count) {
  std::vector<NamedColumn> names;
  for (const char* name : std::span(quantity_names).first(count)) names.push_back({name});
  Columns columns = columns_of_names("", names);
  columns.by_order = true;
  return columns;
}

Columns columns_of_option(std::span<const std::string> option, std::span<const NamedColumn> names,
                          const std::string& file) {
  const auto by_name = [](const std::string& word) { return word.find('=') != word.npos; };
  std::vector<NamedColumn> chosen;
  if (std::ranges::none_of(option, by_name)) {
    for (const std::string& word : option) chosen.push_back({word});
  } else {
    if (!std::ranges::all_of(option, by_name))
      throw std::invalid_argument("--columns: give a quantity for each column (x,y,z), or names for all (x=NAME,...)");
    if (names.empty())
      throw std::invalid_argument(
          fmt::format("--columns: {} has no names of columns: give a quantity for each column (x,y,z)", file));
    for (const NamedColumn& column : names) chosen.push_back({"_", column.count});
    for (const std::string& word : option) {
      const size_t mark = word.find('='), at = find_column(trimmed(word.substr(mark + 1)), names, file);
      if (chosen[at].name != "_")
        throw std::invalid_argument(fmt::format("--columns: '{}' is named twice", names[at].name));
      const KnownName* known = known_name(word.substr(0, mark));
      if (known && known->count != names[at].count)
        throw std::invalid_argument(fmt::format(
            "--columns: '{}' has {} columns in {}, but {} takes {}: three together are pos=NAME or velo=NAME",
            names[at].name, names[at].count, file, known->name, known->count));
      const std::string unit = plain_name(names[at].name).unit;
      chosen[at].name = word.substr(0, mark) + (unit.empty() ? "" : " [" + unit + "]");
    }
  }
  Columns columns = columns_of_names(std::string(option_name), chosen);
  columns.by = "by --columns";
  return columns;
}

std::string complaint_of_column(const std::string& word) {
  const std::string quantity = word.substr(0, word.find('='));
  if (is_word_of_option(quantity)) return "";
  if (quantity != word && (quantity == "pos" || quantity == "velo")) return "";
  std::vector<std::string> known;
  for (const char* name : quantity_names) known.emplace_back(name);
  for (const char* name : other_columns) known.emplace_back(name);
  return unknown_name("column", quantity, known) +
         (quantity == word ? "; a column by its name in the file: x=NAME" : "");
}

std::string describe(const Columns& columns) {
  std::string text;
  for (size_t quantity = 0; quantity < quantity_names.size(); ++quantity) {
    if (!columns.has(Quantity(quantity))) continue;
    const bool half = quantity == QUANTITY_RADIUS && columns.diameters;
    text += fmt::format("{}{}{} {}", text.empty() ? "" : ", ", quantity_names[quantity], half ? " (half of)" : "",
                        *columns.columns[quantity] + 1);
  }
  return fmt::format("columns {}, {}", text, columns.by);
}

}  // namespace spherepair
