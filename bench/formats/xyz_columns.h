// SPDX-License-Identifier: MIT
// Which columns of an XYZ file are what.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "bench/io/file_bytes.h"

namespace spherepair {

struct XyzColumns {
  size_t count = 0;     // on a line
  size_t position = 0;  // x; y and z follow
  std::optional<size_t> radius = {};
  bool named = false;  // by Properties=
  std::string text;    // for the summary
};

// From Properties= of extended XYZ's comment line; none when it has no such key.
std::optional<XyzColumns> named_columns(const FileBytes& file, uint64_t line, std::string_view comment);

// Classic XYZ, `[species] x y z [radius]`, from the first sphere's line.
XyzColumns classic_columns(const FileBytes& file, uint64_t line, std::string_view text);

// What stands between blanks, the first `most` of it; `fields` is written over.
void split_fields(std::string_view text, size_t most, std::vector<std::string_view>& fields);

// A decimal as the nearest float32. `changed` when that is off by more than half a unit of the last digit given.
struct Decimal {
  double value;   // may be infinite or NaN
  float rounded;  // from the text itself, not by way of float64
  bool changed;
};
std::optional<Decimal> parse_decimal(std::string_view text);  // none when it is not a number

// The number in a column that is named so; throws where it is none that a sphere can have.
Decimal read_number(const FileBytes& file, uint64_t line, std::span<const std::string_view> fields, size_t column,
                    const char* name, bool is_radius);

}  // namespace spherepair
