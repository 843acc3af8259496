// SPDX-License-Identifier: MIT
// Reads the names of columns from a comment in a text file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bench/text/column_names.h"

namespace spherepair {

struct ColumnComment {
  std::vector<NamedColumn> names = {};  // one word each, unless the comment is prose
  bool xyz = false;                     // x, y and z are among the names
  bool other_axes = false;              // instead, after another name, three that differ in these letters: id px py pz
  std::vector<std::string> order = {};  // of the words that name columns, if x, y and z are among them

  bool names_columns(size_t count) const { return names.size() == count && (xyz || other_axes); }
  // Whether the comment agrees with x y z, radius, vx vy vz as the order of this many columns.
  bool agrees_with_order(size_t count) const;
};

// Parses `columns: id, x [m], y [m], z [m]`, `1:id 2:x 3:y 4:z`, `[x y z]` or prose, the text after the #.
ColumnComment column_comment(std::string_view text);

}  // namespace spherepair
