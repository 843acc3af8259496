// SPDX-License-Identifier: MIT
#pragma once

#include "common/shared/cell.h"

namespace spherepair {

// The functions of cell.h for dense and for hashed cells, under the same names.
template <bool hashed>
struct CellMap;

template <>
struct CellMap<false> {
  const GridParams& g;
  Cell own(vec4 s, uint) const {
    const GridPosition place = grid_position(s, g);
    return {int(place.x), int(place.y), int(place.z)};
  }
  float reach(float radius, uint) const { return reach_in_cells(radius, g); }
  Cell lowest(vec4 s, float reach, uint) const {
    const GridPosition place = grid_position(s, g);
    return {int(cell_below(place.x, reach)), int(cell_below(place.y, reach)), int(cell_below(place.z, reach))};
  }
  Cell highest(vec4 s, float reach, uint) const {
    const GridPosition place = grid_position(s, g);
    return {int(cell_above(place.x, reach, g.cells_x)), int(cell_above(place.y, reach, g.cells_y)),
            int(cell_above(place.z, reach, g.cells_z))};
  }
  uint row(uint, int y, int z) const { return dense_slot(0, uint(y), uint(z), g); }
  uint slot(uint row, int x) const { return row + uint(x); }
};

template <>
struct CellMap<true> {
  const GridParams& g;
  Cell own(vec4 s, uint level) const { return cell_at(s.x, s.y, s.z, level, g); }
  float reach(float radius, uint level) const { return reach_of(radius, level, g); }
  Cell lowest(vec4 s, float reach, uint level) const { return lowest_cell(s, reach, level, g); }
  Cell highest(vec4 s, float reach, uint level) const { return highest_cell(s, reach, level, g); }
  uint row(uint level, int y, int z) const { return row_slot(level, y, z); }
  uint slot(uint row, int x) const { return slot_in_row(row, x, g); }
};

}  // namespace spherepair
