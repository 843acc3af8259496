// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "common/shared/predicate.h"

namespace spherepair {

// A tile of spheres, one array per component, so that a vector holds consecutive spheres.
constexpr uint tile_columns = 64;
struct alignas(64) ColumnTile {
  float x[tile_columns], y[tile_columns], z[tile_columns], w[tile_columns], radius[tile_columns];
};

constexpr uint tile_rows = 256;
struct RowTile {
  vec4 form[tile_rows];
  float radius[tile_rows];
  uint count;
};

// The columns that may collide with one row: bit b is column first_column + b of the tile.
struct NearColumns {
  uint16_t row, first_column;
  uint64_t bits;
};

// Has room for the worst case: every row near every column. An entry covers at least least_columns columns.
constexpr uint least_columns = 8;
struct NearList {
  NearColumns entry[tile_rows * tile_columns / least_columns];
  uint size;
};

// The Gram filter on vectors of one instruction set.
struct Simd {
  const char* name;
  // Turns the tile's spheres into Gram forms about the origin, in place; w becomes -w of the form.
  void (*form_columns)(ColumnTile& tile, vec4 origin, float share);
  // Lists all columns before `columns` that may collide with a row.
  void (*find_near)(const ColumnTile& tile, uint columns, const RowTile& rows, bool equal_radii, NearList& list);
};

const Simd& best_simd();  // the fastest that this machine can run

}  // namespace spherepair
