// SPDX-License-Identifier: MIT
// The header of an NPY file, versions 1 to 3: the layout of its array.
#pragma once

#include <vector>

#include "common/files/file_bytes.h"

namespace spherepair {

struct NpyField {
  std::string name;       // empty in a plain array
  std::string dtype;      // as in the file: <f4
  uint64_t dtype_at = 0;  // byte offset, for errors
  uint64_t count = 1;     // elements of a field such as ('pos', '<f4', (3,))

  uint64_t item_bytes() const;  // 0: a dtype without a fixed size
};

struct NpyHeader {
  std::vector<NpyField> fields;  // of a structured array; a plain array has one field without a name
  bool structured = false, fortran_order = false;
  std::vector<uint64_t> shape;
  uint64_t shape_at = 0;  // byte offset, for errors
  uint64_t data_at = 0;   // byte offset of the array
};

NpyHeader read_npy_header(const FileBytes& file);

}  // namespace spherepair
