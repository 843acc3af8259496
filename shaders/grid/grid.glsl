// SPDX-License-Identifier: MIT
// The table of cells, and what a cell is.
#include "shaders/buffers.glsl"
#include "common/shared/cell.h"

#ifndef CELL_ACCESS
#define CELL_ACCESS readonly
#endif
layout(std430, binding = SLOT_CELL) restrict CELL_ACCESS buffer CellBuffer { uint cell[]; };

// Of kernels that only read the table: where the spheres of its k-th cell begin, from the slot table_begin on.
#if defined(TEXTURE_TABLE) && !defined(SORTS_SPHERES)
layout(binding = CELL_TEXTURE) uniform usamplerBuffer cell_texture;
#ifdef WINDOWS
layout(location =
           0) uniform uvec2 window;  // the first cell of this dispatch, where the texture begins, and the last's end
uint table_begin() { return window.x; }
#endif
uint begin_at(uint k) { return texelFetch(cell_texture, int(k)).x; }
#else
uint begin_at(uint k) { return cell[k]; }
#endif

// The spheres of this dispatch, from sorted_begin to below sorted_end of the cell order.
#ifdef WINDOWS
uint sorted_begin() { return begin_at(0u); }
uint sorted_end() { return begin_at(window.y - window.x); }
#else
uint table_begin() { return 0u; }
uint sorted_begin() { return 0u; }
uint sorted_end() { return p.n; }
#endif

// The spheres, of kernels that sort them.
#if defined(TEXTURE_TABLE) && defined(SORTS_SPHERES)
layout(binding = SPHERE_TEXTURE) uniform usamplerBuffer sphere_texture;
vec4 sphere_of(uint i) { return uintBitsToFloat(texelFetch(sphere_texture, int(i))); }
#else
vec4 sphere_of(uint i) { return position[i]; }
#endif
