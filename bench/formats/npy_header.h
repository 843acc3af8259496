// SPDX-License-Identifier: MIT
// The header of an NPY file, versions 1 to 3: how the array behind it is laid out.
#pragma once

#include <vector>

#include "bench/io/file_bytes.h"

namespace spherepair {

struct NpyHeader {
  std::string dtype;  // as it stands there: <f4
  bool fortran_order = false;
  std::vector<uint64_t> shape;
  uint64_t dtype_at = 0, shape_at = 0;  // bytes where they stand, for errors
  uint64_t data_at = 0;                 // byte where the array begins
};

NpyHeader read_npy_header(const FileBytes& file);

}  // namespace spherepair
