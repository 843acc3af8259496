// SPDX-License-Identifier: MIT
#include "common/device/launch.h"

#include <algorithm>

namespace spherepair {
namespace {

// A slot as the kernel sees it, and the slot whose buffer the launch puts there.
struct Choice {
  uint seen, used;
};
std::array<Choice, 7> choices(const Launch& launch) {
  return {{{SLOT_POSITION, position_slot(launch.order)},
           {SLOT_COUNT, count_slot(launch)},
           {SLOT_SPLIT_ID, id_slot(launch.order)},
           {SLOT_SORTED, position_slot(launch.target)},
           {SLOT_ID, id_slot(launch.target)},
           {SLOT_CELL, launch.table},
           {SLOT_VISIBLE, launch.visible_slot}}};
}

Uses table_of(Kernel kernel) {
  using namespace slots;
#define USES(name, reads, writes) {reads, writes},
  static constexpr Uses uses[] = {SPHEREPAIR_KERNELS(USES)};
#undef USES
  return uses[int(kernel)];
}

Slots chosen(const Launch& launch, Slots seen) {
  Slots used = seen;
  for (const Choice& choice : choices(launch)) used &= ~(Slots(1) << choice.seen);
  for (const Choice& choice : choices(launch)) used |= (seen >> choice.seen & 1) << choice.used;
  return used;
}

}  // namespace

const char* kernel_name(Kernel kernel) {
#define NAME(name, reads, writes) #name,
  static constexpr const char* names[] = {SPHEREPAIR_KERNELS(NAME)};
#undef NAME
  return names[int(kernel)];
}

std::array<uint, 3> folded(uint64_t groups) {
  const uint64_t y = ceil_div(groups, MAX_GROUPS);
  return {uint(y > 1 ? MAX_GROUPS : std::max<uint64_t>(groups, 1)), uint(std::max<uint64_t>(y, 1)), 1};
}

BufferHandles seen_buffers(const Launch& launch, const BufferHandles& buffers) {
  BufferHandles seen = buffers;
  for (const Choice& choice : choices(launch)) seen[choice.seen] = buffers[choice.used];
  return seen;
}

Uses uses_of(const Launch& launch) {
  const auto [reads, writes] = table_of(launch.kernel);
  return {chosen(launch, reads & ~launch.unused), chosen(launch, writes & ~launch.unused)};
}

}  // namespace spherepair
