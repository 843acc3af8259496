// SPDX-License-Identifier: MIT
// Where the numbers of an NPY array stand, and what they are.
#pragma once

#include <span>

#include "bench/npy/npy_header.h"
#include "bench/text/column_names.h"

namespace spherepair {

struct NpyColumn {
  Quantity quantity;
  std::string_view dtype;
  uint64_t first, stride;  // bytes: of row 0, from row to row
};

struct NpyArray {
  const FileBytes& file;
  uint64_t rows = 0;
  std::vector<NpyColumn> columns = {};
  std::string not_read = {};  // names of other fields
  Columns meaning = {};

  uint64_t byte_of(uint64_t row, const NpyColumn& column) const { return column.first + row * column.stride; }
};

// Whether a dtype is one of real numbers that are read.
bool is_real_dtype(std::string_view dtype);

// Checks dtypes, shape and size. option: the words of --columns, if given.
NpyArray array_of(const FileBytes& file, const NpyHeader& header, std::span<const std::string> option);

std::string describe(const NpyArray& array, const NpyHeader& header);

}  // namespace spherepair
