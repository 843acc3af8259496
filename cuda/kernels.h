// SPDX-License-Identifier: MIT
// The arguments of every kernel, and the host's access to kernels: one entry a file, by group size and variant.
#pragma once

#include <cstddef>

#include "common/device/buffer_list.h"
#include "common/device/kernel_list.h"
#include "common/device/variant.h"
#include "common/shared/layout.h"

namespace spherepair {

struct AxisBuffer {
  Axis* of;
};

// The buffers of layout.h: one address a slot, in order.
struct KernelBuffers {
#define ONE(slot, type, name, words) type name;
#define THREE(slot, type, name, words) type name[3];
  SPHEREPAIR_BUFFERS(ONE, THREE)
#undef ONE
#undef THREE
};
#define SAME_SLOT(slot, type, name, words) static_assert(offsetof(KernelBuffers, name) == SLOT_##slot * sizeof(void*));
SPHEREPAIR_BUFFERS(SAME_SLOT, SAME_SLOT)
#undef SAME_SLOT

// Every kernel is void (Params p, KernelBuffers buf); kernels that draw also take a View v. A null entry means a group
// size or a variant that was not compiled. Kernels with one form ignore both.
using Entry = const void*;
#define DECLARE(name, reads, writes) Entry name##_kernel(uint block, Variant variant);
SPHEREPAIR_KERNELS(DECLARE)
#undef DECLARE

}  // namespace spherepair
