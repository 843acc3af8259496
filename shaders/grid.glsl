// SPDX-License-Identifier: MIT
// The buffers that put spheres into cell order.
#include "buffers.glsl"
#include "cell.h"

layout(std430, binding = SLOT_CELL) restrict buffer CellBuffer { uint cell[]; };
layout(std430, binding = SLOT_RANK) restrict buffer RankBuffer { uint rank[]; };
layout(std430, binding = SLOT_SORTED) restrict buffer SortedBuffer { vec4 sorted[]; };
layout(std430, binding = SLOT_SORTED_COUNT) restrict buffer SortedCountBuffer { uint sorted_count[]; };
layout(std430, binding = SLOT_SCAN) restrict buffer ScanBuffer { uint scan[]; };
