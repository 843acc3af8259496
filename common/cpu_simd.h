// SPDX-License-Identifier: MIT
#pragma once

#include "predicate.h"

namespace spherepair {

// Columns of a tile in Gram form, component by component; `minus_w` is -w of the form.
constexpr uint tile_columns = 512;
constexpr uint chunk_columns = 32;
constexpr uint rows_at_once = 4;
constexpr uint lanes = 16;  // of a vector; where the machine's are narrower, the compiler takes several
constexpr uint chunks = tile_columns / chunk_columns, vectors = chunk_columns / lanes;
struct alignas(64) ColumnTile {
  float x[tile_columns], y[tile_columns], z[tile_columns], minus_w[tile_columns], radius[tile_columns];
};

// Rows against all columns of a tile: for every chunk of columns, whether any of them may collide with any of the rows,
// and if so which, a bit a column.
struct NearColumns {
  bool near[chunks];
  uint16_t columns[chunks][rows_at_once][vectors];
};
void meet_tile(const ColumnTile& tile, const vec4 (&rows)[rows_at_once], const float (&radii)[rows_at_once],
               bool equal_radii, NearColumns& result);

}  // namespace spherepair
