// SPDX-License-Identifier: MIT
// The columns of an XYZ file.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "bench/io/file_bytes.h"

namespace spherepair {

struct XyzColumns {
  size_t count = 0;     // on a line
  size_t position = 0;  // x; y and z follow
  std::optional<size_t> radius = {}, species = {};
  bool named = false;  // by Properties=
  std::string text;    // for the summary
};

// From Properties= in the comment line of extended XYZ; none without that key.
std::optional<XyzColumns> named_columns(const FileBytes& file, uint64_t line, std::string_view comment);

// Classic XYZ, `[species] x y z [radius]`, from the first sphere's line.
XyzColumns classic_columns(const FileBytes& file, uint64_t line, std::string_view text);

// Splits at blanks into at most `most` fields; overwrites `fields`.
void split_fields(std::string_view text, size_t most, std::vector<std::string_view>& fields);

// A decimal and the nearest float32. `changed`: they differ by more than half a unit of the last given digit.
struct Decimal {
  double value;   // may be infinite or NaN
  float rounded;  // from the text, not from the float64 value
  bool changed;
};
std::optional<Decimal> parse_decimal(std::string_view text);  // none if it is not a number

// The number in a column called `name`; throws if it is invalid.
Decimal read_number(const FileBytes& file, uint64_t line, std::span<const std::string_view> fields, size_t column,
                    const char* name, bool is_radius);

}  // namespace spherepair
