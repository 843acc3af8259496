// SPDX-License-Identifier: MIT
// The cells of the uniform grid. A coordinate's cell number is a chain of one subtraction, one multiplication, a clamp
// and a truncation, each of which is monotonic however it rounds. So x <= y gives cell(x) <= cell(y) for all floats.
// Hashed cells: a sphere that reaches down to x - reach can only collide with spheres of the cells from cell(x - reach)
// on, at any distance from the origin; reach_of rounds upwards. Dense cells subtract the reach after the
// multiplication, so reach_in_cells has a margin. A cell belongs to a level, chosen by the radii of its spheres; the
// cells of level k are 2^k times as wide as those of level 0.
#ifndef SPHEREPAIR_CELL_H
#define SPHEREPAIR_CELL_H

#include "common/shared/layout.h"

struct Cell {
  int x, y, z;
};

// A position in cells of a dense grid, from 0 to the number of cells - 1; spheres outside belong to the border.
struct GridPosition {
  float x, y, z;
};
FN float grid_coordinate(float x, float origin, float scale, uint cells) {
  EXACT float offset = x - origin;
  EXACT float coordinate = offset * scale;
  return smaller(larger(coordinate, 0.0f), float(cells - 1u));
}
FN GridPosition grid_position(vec4 sphere, GridParams g) {
  GridPosition position = {grid_coordinate(sphere.x, g.origin_x, g.cells_per_metre, g.cells_x),
                           grid_coordinate(sphere.y, g.origin_y, g.cells_per_metre, g.cells_y),
                           grid_coordinate(sphere.z, g.origin_z, g.cells_per_metre, g.cells_z)};
  return position;
}
// Returns the reach in cells of a dense grid: at least radius + largest radius, with a margin for the rounding of two
// coordinates. It is less than 1, so that a neighbourhood is at most three cells wide.
FN float reach_in_cells(float radius, GridParams g) {
  EXACT float reach = multiply_add(radius, g.reach_scale, g.reach_offset);
  return reach;
}
FN uint cell_below(float coordinate, float reach) {
  EXACT float low = coordinate - reach;
  return uint(larger(low, 0.0f));
}
FN uint cell_above(float coordinate, float reach, uint cells) {
  EXACT float high = coordinate + reach;
  return uint(smaller(high, float(cells - 1u)));
}
FN uint dense_slot(uint x, uint y, uint z, GridParams g) { return (z * g.cells_y + y) * g.cells_x + x; }

// Returns the level of a radius: its octave above the smallest; always 0 if there is only one level.
FN uint level_of(float radius, GridParams g) {
  uint octave = (float_bits(radius) >> 23) & 0xFFu;
  uint above = octave > g.first_octave ? octave - g.first_octave : 0u;
  return above < g.top_level ? above : g.top_level;
}

const int MOST_CELLS = 1073741824;  // the largest cell number, in each direction

FN int cell_number(float x, float origin, float scale) {
  EXACT float offset = x - origin;
  EXACT float coordinate = offset * scale;
  return int(smaller(larger(coordinate, -float(MOST_CELLS)), float(MOST_CELLS)));
}

FN float cells_per_metre(uint level, GridParams g) {
  EXACT float scaled = g.cells_per_metre * bits_float((127u - level) << 23);
  return scaled;
}

FN Cell cell_at(float x, float y, float z, uint level, GridParams g) {
  float scale = cells_per_metre(level, g);
  Cell cell = {cell_number(x, g.origin_x, scale), cell_number(y, g.origin_y, scale), cell_number(z, g.origin_z, scale)};
  return cell;
}

// Returns the hashed slot at which the row of cells y, z begins. Its cells have consecutive slots, modulo the table's
// size. Rows may share slots.
FN uint row_slot(uint level, int y, int z) {
  uint h = uint(y) * 0x9E3779B1u + uint(z) * 0x85EBCA77u + level * 0xC2B2AE3Du;
  h = (h ^ (h >> 16)) * 0x7FEB352Du;
  h = (h ^ (h >> 15)) * 0x846CA68Bu;
  return h ^ (h >> 16);
}

FN uint slot_in_row(uint row, int x, GridParams g) { return (row + uint(x)) & g.hash_mask; }

// Return the corners of the range of cells on a level whose spheres this sphere may collide with.
FN Cell lowest_cell(vec4 sphere, float reach, uint level, GridParams g) {
  EXACT float x = sphere.x - reach;
  EXACT float y = sphere.y - reach;
  EXACT float z = sphere.z - reach;
  return cell_at(x, y, z, level, g);
}
FN Cell highest_cell(vec4 sphere, float reach, uint level, GridParams g) {
  EXACT float x = sphere.x + reach;
  EXACT float y = sphere.y + reach;
  EXACT float z = sphere.z + reach;
  return cell_at(x, y, z, level, g);
}

// One level of a dense grid. The tables of the levels follow each other in SLOT_CELL. A search has one level only;
// draw_light may have several.
struct DenseLevel {
  float scale;  // cells per metre
  uint first_slot, cells_x, cells_y, cells_z;
};
FN DenseLevel lowest_level(GridParams g) {
  DenseLevel level = {g.cells_per_metre, 0u, g.cells_x, g.cells_y, g.cells_z};
  return level;
}
FN DenseLevel level_above(DenseLevel l) {
  EXACT float scale = l.scale * 0.5f;
  uint first_slot = l.first_slot + l.cells_x * l.cells_y * l.cells_z;
  DenseLevel level = {scale, first_slot, (l.cells_x + 1u) >> 1, (l.cells_y + 1u) >> 1, (l.cells_z + 1u) >> 1};
  return level;
}
FN uint slot_in_level(uint x, uint y, uint z, DenseLevel l) {
  return l.first_slot + (z * l.cells_y + y) * l.cells_x + x;
}

FN uint dense_slot_of(vec4 sphere, GridParams g) {
  DenseLevel l = lowest_level(g);
  if (g.top_level != 0u)
    for (uint above = level_of(sphere.w, g); above > 0u; --above) l = level_above(l);
  float x = grid_coordinate(sphere.x, g.origin_x, l.scale, l.cells_x);
  float y = grid_coordinate(sphere.y, g.origin_y, l.scale, l.cells_y);
  float z = grid_coordinate(sphere.z, g.origin_z, l.scale, l.cells_z);
  return slot_in_level(uint(x), uint(y), uint(z), l);
}
FN uint hashed_slot_of(vec4 sphere, GridParams g) {
  uint level = level_of(sphere.w, g);
  Cell cell = cell_at(sphere.x, sphere.y, sphere.z, level, g);
  return slot_in_row(row_slot(level, cell.y, cell.z), cell.x, g);
}
// Returns a sphere's slot. dense: a compile-time constant, so that no code for the other grid is generated.
FN uint slot_of(vec4 sphere, bool dense, GridParams g) {
  return dense || g.hash_mask == 0u ? dense_slot_of(sphere, g) : hashed_slot_of(sphere, g);
}
FN uint slot_of(vec4 sphere, GridParams g) { return slot_of(sphere, false, g); }

// Whether a sphere belongs to this level and is in this row of its cells.
FN bool stands_in_row(vec4 sphere, uint level, int y, int z, GridParams g) {
  if (level_of(sphere.w, g) != level) return false;
  Cell cell = cell_at(sphere.x, sphere.y, sphere.z, level, g);
  return cell.y == y && cell.z == z;
}

// Returns a bound on radius + the largest radius of a level, not below the sum in real arithmetic.
FN float reach_of(float radius, uint level, GridParams g) {
  EXACT float largest = g.largest_radius * bits_float((127u + level) << 23);
  EXACT float sum = radius + largest;
  EXACT float reach = multiply_add(sum, bits_float(0x3F800010u), bits_float(0x0D800000u));  // 1 + 2^-19, 2^-100
  return reach;
}

// Packs the range of a bucket's spheres within a sorted tile into one word: begin, and end in the upper half.
FN uint run_in_tile(uint begin, uint end) { return begin | end << 16; }
FN uint begin_in_tile(uint run) { return run & 0xFFFFu; }
FN uint end_in_tile(uint run) { return run >> 16; }

// Buckets are ranges of slots; parents are larger ranges. The spheres of this slot's parent are in the buckets from
// bucket_below to bucket_above.
FN uint bucket_below(uint slot, SortParams s) { return (slot >> s.parent_shift) << (s.parent_shift - s.bucket_shift); }
FN uint bucket_above(uint slot, SortParams s) {
  uint behind = ((slot >> s.parent_shift) + 1u) << (s.parent_shift - s.bucket_shift);
  return (behind < s.buckets ? behind : s.buckets) - 1u;
}

#endif
