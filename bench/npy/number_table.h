// SPDX-License-Identifier: MIT
// Where binary numbers of spheres stand in files, and what they are.
#pragma once

#include <vector>

#include "bench/io/file_bytes.h"
#include "bench/text/column_names.h"

namespace spherepair {

struct NumberColumn {
  const FileBytes* file;
  Quantity quantity;
  std::string_view dtype;             // of NPY: <f4, >i2 ...
  uint64_t first, stride;             // bytes: of row 0, from row to row; ...
  std::vector<uint64_t> places = {};  // ... or the byte in each row, where rows differ in length

  uint64_t byte_of(uint64_t row) const { return places.empty() ? first + row * stride : places[row]; }
};

struct NumberTable {
  const FileBytes& file;  // for errors
  uint64_t rows = 0;
  std::vector<NumberColumn> columns = {};
  std::string not_read = {};  // names of other fields
  Columns meaning = {};
};

}  // namespace spherepair
