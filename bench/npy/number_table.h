// SPDX-License-Identifier: MIT
// Positions and types of the binary numbers of spheres in a file.
#pragma once

#include <vector>

#include "bench/text/column_names.h"
#include "common/files/file_bytes.h"

namespace spherepair {

struct NumberColumn {
  const FileBytes* file;
  Quantity quantity;
  std::string_view dtype;             // of NPY: <f4, >i2 ...
  uint64_t first, stride;             // bytes: the offset of row 0, the distance of rows ...
  std::vector<uint64_t> places = {};  // ... or the offset in each row, if rows differ in length

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
