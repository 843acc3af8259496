// SPDX-License-Identifier: MIT
// The table of cells, and what a cell is.
#include "buffers.glsl"
#include "cell.h"

#ifndef CELL_ACCESS
#define CELL_ACCESS readonly
#endif
layout(std430, binding = SLOT_CELL) restrict CELL_ACCESS buffer CellBuffer { uint cell[]; };
