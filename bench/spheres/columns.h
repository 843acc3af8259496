// SPDX-License-Identifier: MIT
// The columns of a text file: what they mean, and the numbers in them.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "bench/io/file_bytes.h"

namespace spherepair {

enum Quantity : size_t { QUANTITY_X, QUANTITY_Y, QUANTITY_Z, QUANTITY_RADIUS, QUANTITY_VX, QUANTITY_VY, QUANTITY_VZ };
inline constexpr std::array<const char*, 7> quantity_names = {"x", "y", "z", "radius", "vx", "vy", "vz"};

struct Columns {
  size_t count = 0;                                                       // on a line
  std::array<std::optional<size_t>, quantity_names.size()> columns = {};  // where each quantity stands
  std::optional<size_t> species = {};                                     // a column of text
  bool momenta = false;                                                   // are among those that are not read
  std::string text;                                                       // for the summary

  bool has(Quantity quantity) const { return columns[quantity].has_value(); }
  size_t quantities() const;  // that are there
};

// By the names of quantities; other columns are not read. Throws std::invalid_argument, whose message begins with
// `where`, for a name that stands twice, and without x, y and z or with some of vx, vy, vz only.
Columns columns_of_names(const std::string& where, std::span<const std::string> names);

// Splits at blanks, or at every semicolon, or else comma, of a line that has one, into at most `most` fields;
// overwrites `fields`.
void split_fields(std::string_view text, size_t most, std::vector<std::string_view>& fields);
void split_separated_fields(std::string_view text, size_t most, std::vector<std::string_view>& fields);

// A decimal and the nearest float32. `changed`: they differ by more than half a unit of the last given digit.
struct Decimal {
  double value;   // may be infinite or NaN
  float rounded;  // from the text, not from the float64 value
  bool changed;
};
std::optional<Decimal> parse_decimal(std::string_view text);  // none if it is not a number

// The number of this quantity on a line; throws if it is invalid.
Decimal read_number(const FileBytes& file, uint64_t line, std::span<const std::string_view> fields,
                    const Columns& columns, Quantity quantity);

}  // namespace spherepair
