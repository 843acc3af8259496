// SPDX-License-Identifier: MIT
// Finds the meaning of a file's columns by their names or by --columns.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace spherepair {

enum Quantity : size_t { QUANTITY_X, QUANTITY_Y, QUANTITY_Z, QUANTITY_RADIUS, QUANTITY_VX, QUANTITY_VY, QUANTITY_VZ };
inline constexpr std::array<const char*, 7> quantity_names = {"x", "y", "z", "radius", "vx", "vy", "vz"};

// Words of --columns that are not quantities: a diameter, which is twice the radius; a column of text; a column that is
// not read.
inline constexpr std::array<const char*, 3> other_columns = {"diameter", "species", "_"};

struct Columns {
  size_t count = 0;                                                       // on a line
  std::array<std::optional<size_t>, quantity_names.size()> columns = {};  // the column of each quantity
  std::optional<size_t> species = {};                                     // the column of text
  bool diameters = false;                                                 // the column of radii has diameters
  bool by_order = false;                                                  // no names: the number of columns decides
  bool momenta = false;                                                   // momenta are among the unread columns
  std::string text = {};                                                  // the names of all columns
  std::string by = {};                                                    // the source of this meaning
  std::string units = {};                                                 // of lengths, as in the file

  bool has(Quantity quantity) const { return columns[quantity].has_value(); }
  size_t quantities() const;  // number of quantities present
};

// One column, or several with one name: pos has three.
struct NamedColumn {
  std::string name = {};
  uint64_t count = 1;
};

// A known name, in lower case and without its unit.
struct KnownName {
  std::string_view name;
  Quantity first;
  uint64_t count = 1;
};
const KnownName* known_name(std::string_view name);  // null if it is unknown

std::string all_names(std::span<const NamedColumn> names);  // with unprintable bytes as \x..

// Finds columns by the names that programs use: x and `X [mm]`, radius, diameter, pos, velo ...; others are not read. r
// is a radius unless g and b, or angles, are among the names. If several names fit a quantity, one of three components
// wins (pos over Z), else the one in lower case (z over Z). Throws std::invalid_argument, whose message begins with
// `where`, if a quantity appears twice, if units differ, if x, y or z is missing, or if only some of vx, vy and vz
// exist.
Columns columns_of_names(const std::string& where, std::span<const NamedColumn> names);

// Columns by their order: x y z, then radius, then vx vy vz.
Columns columns_by_order(size_t count);

// Finds columns by --columns: quantities in the order of the columns; or x=NAME,y=NAME ... or pos=NAME with names of
// the file. Throws std::invalid_argument.
Columns columns_of_option(std::span<const std::string> option, std::span<const NamedColumn> names,
                          const std::string& file);

// The fault of a word of --columns; empty if it is valid.
std::string complaint_of_column(const std::string& word);

// The columns and their quantities as text, for the summary.
std::string describe(const Columns& columns);

}  // namespace spherepair
