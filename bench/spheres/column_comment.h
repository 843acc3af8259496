// SPDX-License-Identifier: MIT
// What a comment in a file of text says of the columns.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bench/text/column_names.h"

namespace spherepair {

struct ColumnComment {
  std::vector<NamedColumn> names = {};  // one word each, unless it is prose
  bool xyz = false;                     // x, y and z are among the names
  bool other_axes = false;              // or names that differ in these letters, after another: id px py pz
  std::vector<std::string> order = {};  // of its words that name columns, if x, y and z are among them

  bool names_columns(size_t count) const { return names.size() == count && (xyz || other_axes); }
  // Whether x y z, radius, vx vy vz, by their order, are what it says of this many columns.
  bool agrees_with_order(size_t count) const;
};

// `# columns: id, x [m], y [m], z [m]`, `# 1:id 2:x 3:y 4:z`, `# [x y z]` or prose; without the #.
ColumnComment column_comment(std::string_view text);

}  // namespace spherepair
