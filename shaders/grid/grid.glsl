// SPDX-License-Identifier: MIT
// The table of cells: the sorted index at which the spheres of each cell begin.
#include "shaders/kernels.glsl"
#include "common/shared/cell.h"

#ifndef CELL_ACCESS
#define CELL_ACCESS readonly
#endif
layout(std430, binding = SLOT_CELL) restrict CELL_ACCESS buffer CellBuffer { uint cell[]; };

// GLSL only from here: a large table comes through texture buffers, in windows of which a dispatch reads one
#ifdef TEXTURE_TABLE
layout(binding = CELL_TEXTURE) uniform usamplerBuffer cell_texture;
#ifdef WINDOWS
layout(
    location = 0) uniform uvec2 window;  // the dispatch's first cell, at which the texture begins, and its last's end
uint table_begin() { return window.x; }
#endif
uint begin_at(uint k) { return texelFetch(cell_texture, int(k)).x; }
#else
// until here
// For kernels that only read the table: returns where the spheres of the cell at slot table_begin() + k begin.
uint begin_at(uint k) { return cell[k]; }
#endif  // GLSL only: ends the choice above

// This dispatch handles the spheres from sorted_begin to before sorted_end.
// GLSL only from here: windows of the table
#ifdef WINDOWS
uint sorted_begin() { return begin_at(0u); }
uint sorted_end() { return begin_at(window.y - window.x); }
#else
// until here
uint table_begin() { return 0u; }
uint sorted_begin() { return 0u; }
uint sorted_end() { return p.n; }
#endif  // GLSL only: ends the choice above
