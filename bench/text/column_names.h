// SPDX-License-Identifier: MIT
// What the columns of a file mean, by their names or by --columns.
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

// Words of --columns that are no quantity: the radius is half of the diameter; a column that is not read; one of text.
inline constexpr std::array<const char*, 3> other_columns = {"diameter", "species", "_"};

struct Columns {
  size_t count = 0;                                                       // on a line
  std::array<std::optional<size_t>, quantity_names.size()> columns = {};  // where each quantity stands
  std::optional<size_t> species = {};                                     // a column of text
  bool diameters = false;                                                 // stand in the column of radii
  bool by_order = false;                                                  // no names: the number of columns tells
  bool momenta = false;                                                   // are among those that are not read
  std::string text = {};                                                  // the names of all
  std::string by = {};                                                    // what says so
  std::string units = {};                                                 // of lengths, as in the file

  bool has(Quantity quantity) const { return columns[quantity].has_value(); }
  size_t quantities() const;  // that are there
};

// One column, or several that have one name: pos of three.
struct NamedColumn {
  std::string name = {};
  uint64_t count = 1;
};

// A name that is known, in lower case and without its unit.
struct KnownName {
  std::string_view name;
  Quantity first;
  uint64_t count = 1;
};
const KnownName* known_name(std::string_view name);  // null if it is not

std::string all_names(std::span<const NamedColumn> names);  // with unprintable bytes as \x..

// Columns by the names that programs give them: x and `X [mm]`, radius, diameter, pos, velo ...; others are not read. r
// is a radius unless g and b, or angles, stand beside it. Of several names for a quantity one of three components is
// taken (pos beside Z), else the one in lower case (z beside Z). Throws std::invalid_argument, whose message begins
// with `where`, if a quantity stands twice, if units differ, if x, y or z is missing, or if only some of vx, vy and vz
// are there.
Columns columns_of_names(const std::string& where, std::span<const NamedColumn> names);

// Columns by their order: x y z, then radius, then vx vy vz.
Columns columns_by_order(size_t count);

// By --columns: quantities in the order of the columns; or x=NAME,y=NAME ... or pos=NAME of the names in the file.
// Throws std::invalid_argument.
Columns columns_of_option(std::span<const std::string> option, std::span<const NamedColumn> names,
                          const std::string& file);

// What is wrong with a word of --columns; empty if nothing is.
std::string complaint_of_column(const std::string& word);

// For the summary: which columns are which quantities.
std::string describe(const Columns& columns);

}  // namespace spherepair
