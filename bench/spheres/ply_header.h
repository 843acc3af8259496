// SPDX-License-Identifier: MIT
// Reads the header of a PLY file: its elements, their properties and the start of the data.
#pragma once

#include <algorithm>
#include <vector>

#include "bench/io/file_lines.h"

namespace spherepair {

struct PlyProperty {
  std::string name;
  std::string dtype;              // as NPY names it: <f4; for a list the type of its entries
  std::string length_dtype = {};  // of a list; else empty

  bool is_list() const { return !length_dtype.empty(); }
};

struct PlyElement {
  std::string name;
  uint64_t count = 0;
  uint64_t line = 0;  // in the header
  std::vector<PlyProperty> properties = {};

  bool has_lists() const { return std::ranges::any_of(properties, &PlyProperty::is_list); }
};

struct PlyHeader {
  std::string format;  // ascii, binary_little_endian or binary_big_endian
  std::vector<PlyElement> elements;
  size_t vertex = 0;  // the index of the element with the spheres
  FileLines data;
};

PlyHeader read_ply_header(const FileBytes& file);

// The size of a dtype such as <f4, whose last character is a digit.
inline uint64_t bytes_of_dtype(std::string_view dtype) { return uint64_t(dtype.back() - '0'); }

}  // namespace spherepair
