// SPDX-License-Identifier: MIT
// The header of an NPY file, versions 1 to 3: the layout of its array.
#pragma once

#include <vector>

#include "bench/io/file_bytes.h"

namespace spherepair {

struct NpyHeader {
  std::string dtype;  // as in the file: <f4
  bool fortran_order = false;
  std::vector<uint64_t> shape;
  uint64_t dtype_at = 0, shape_at = 0;  // their byte offsets, for errors
  uint64_t data_at = 0;                 // byte offset of the array
};

NpyHeader read_npy_header(const FileBytes& file);

}  // namespace spherepair
