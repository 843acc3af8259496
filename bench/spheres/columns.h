// SPDX-License-Identifier: MIT
// Reads the numbers of a file's lines, a sphere each.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "bench/text/column_names.h"
#include "common/files/file_bytes.h"

namespace spherepair {

struct SphereRows;

// A decimal and the nearest float32. `changed`: they differ by more than half a unit of the last given digit.
struct Decimal {
  double value;   // may be infinite or NaN
  float rounded;  // from the text, not from the float64 value
  bool changed;
};
// None if the text is not a number. The exponent's letter is e, E, d or D.
std::optional<Decimal> parse_decimal(std::string_view text, bool decimal_comma = false);

Decimal halved(const Decimal& diameter);

// Reads the fields of lines into rows of spheres. Throws std::invalid_argument with the line for a wrong number of
// fields and for a field that is not a valid number.
class RowReader {
 public:
  RowReader(const FileBytes& file, const Columns& columns, bool decimal_comma)
      : file_(file), columns_(columns), decimal_comma_(decimal_comma) {}

  void read(uint64_t line, std::string_view text, std::span<const std::string_view> fields, uint64_t sphere,
            SphereRows& rows);
  uint64_t changed() const { return changed_; }  // numbers that rounding to float32 changed

 private:
  Decimal number(uint64_t line, std::string_view field, Quantity quantity) const;

  const FileBytes& file_;
  const Columns& columns_;
  bool decimal_comma_;
  uint64_t changed_ = 0;
};

}  // namespace spherepair
