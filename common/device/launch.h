// SPDX-License-Identifier: MIT
// One launch of a kernel, in the form that every GPU API takes.
#pragma once

#include <array>
#include <optional>

#include "common/device/buffer_list.h"
#include "common/device/kernel_list.h"
#include "common/device/memory.h"
#include "common/device/variant.h"
#include "common/shared/view.h"

namespace spherepair {

#define ENUMERATOR(name, reads, writes) name,
enum class Kernel { SPHEREPAIR_KERNELS(ENUMERATOR) };
#undef ENUMERATOR
#define ONE_MORE(name, reads, writes) +1
constexpr size_t kernel_count = SPHEREPAIR_KERNELS(ONE_MORE);
#undef ONE_MORE

const char* kernel_name(Kernel kernel);  // the stem of its two source files

// Sets of buffers, one bit a slot; the constants are named as in kernels.
using Slots = uint64_t;
namespace slots {
constexpr Slots none = 0;
#define ONE(slot, type, name, words) constexpr Slots name = Slots(1) << SLOT_##slot;
#define THREE(slot, type, name, words) constexpr Slots name = Slots(7) << SLOT_##slot;
SPHEREPAIR_BUFFERS(ONE, THREE)
#undef ONE
#undef THREE
}  // namespace slots

constexpr uint64_t ceil_div(uint64_t a, uint64_t b) { return (a + b - 1) / b; }

// Returns a grid for `groups` groups along x, folded into y if one dispatch cannot hold them.
std::array<uint, 3> folded(uint64_t groups);

// The copy of the spheres that a kernel sees as positions, contact counts and sphere indices.
enum class Order { scene, buckets, cells };
inline uint position_slot(Order order) {
  return order == Order::cells ? SLOT_SORTED : order == Order::buckets ? SLOT_SPLIT : SLOT_POSITION;
}
inline uint id_slot(Order order) { return order == Order::buckets ? SLOT_SPLIT_ID : SLOT_ID; }
inline uint colour_slot(const View& view) { return view.colour_by == COLOUR_BY_CONTACTS ? SLOT_COUNT : SLOT_COLOUR; }
inline uint count_slot(Order order) { return order == Order::cells ? SLOT_SORTED_COUNT : SLOT_COUNT; }

struct Launch {
  Kernel kernel;
  uint block;  // threads per group
  Variant variant = {};
  std::array<uint, 3> groups = {1, 1, 1};
  Order order = Order::scene;        // copy that the kernel reads
  Order target = Order::cells;       // copy that the kernel writes
  uint table = SLOT_CELL;            // table of the scan
  const char* stage = nullptr;       // name of its time, if not the kernel's
  Slots unused = 0;                  // buffers, by the kernel's names, that it does not use with these parameters
  bool depends = false;              // waits for the previous launches, whatever they use
  const View* view = nullptr;        // of drawing kernels; they see as counts what chooses the colours, by sphere index
  uint visible_slot = SLOT_VISIBLE;  // of drawing kernels
  uint steps = 0;                    // of persistent_steps, whose groups must all run at once
  uint64_t texels = 0;               // GLSL with variant.texture_table: elements of the buffer texture
};

inline uint count_slot(const Launch& launch) {
  return launch.view ? colour_slot(*launch.view) : count_slot(launch.order);
}

// Returns the buffers in the slots where the kernel sees them.
BufferHandles seen_buffers(const Launch& launch, const BufferHandles& buffers);

// Slots that a launch reads and slots that it writes.
struct Uses {
  Slots reads = 0, writes = 0;
};
Uses uses_of(const Launch& launch);

inline const char* stage_name(const Launch& launch) { return launch.stage ? launch.stage : kernel_name(launch.kernel); }

}  // namespace spherepair
