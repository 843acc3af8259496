// SPDX-License-Identifier: MIT
// The table of cells, and what a cell is.
#include "buffers.glsl"
#include "cell.h"

#ifndef CELL_ACCESS
#define CELL_ACCESS readonly
#endif
layout(std430, binding = SLOT_CELL) restrict CELL_ACCESS buffer CellBuffer { uint cell[]; };

// Where a cell's spheres begin, of kernels that only read the table.
#if defined(TEXTURE_TABLE) && !defined(SORTS_SPHERES)
layout(binding = 0) uniform usamplerBuffer cell_texture;
uint cell_begin(uint slot) { return texelFetch(cell_texture, int(slot)).x; }
#else
uint cell_begin(uint slot) { return cell[slot]; }
#endif

// The spheres, of kernels that sort them.
#if defined(TEXTURE_TABLE) && defined(SORTS_SPHERES)
layout(binding = 0) uniform usamplerBuffer sphere_texture;
vec4 sphere_of(uint i) { return uintBitsToFloat(texelFetch(sphere_texture, int(i))); }
#else
vec4 sphere_of(uint i) { return position[i]; }
#endif
