// SPDX-License-Identifier: MIT
// What a kernel sees of a device's memory, by slot.
#pragma once

#include "common/device/launch.h"
#include "cuda/kernels.h"

namespace spherepair {

// An address that becomes a pointer to whatever it is given to.
struct Address {
  void* data;
  template <typename T>
  operator T*() const {
    return static_cast<T*>(data);
  }
};

// memory(slot): the address of its buffer.
template <typename Memory>
KernelBuffers kernel_buffers(const Launch& launch, Memory memory) {
  const auto at = [&](uint slot) { return Address{memory(slot)}; };
  return {.position = at(position_slot(launch.order)),
          .velocity = at(SLOT_VELOCITY),
          .count = at(count_slot(launch)),
          .summary = at(SLOT_SUMMARY),
          .deferred = at(SLOT_DEFERRED),
          .listed = at(SLOT_PAIR),
          .spheres = at(SLOT_SPHERES),
          .verdict = at(SLOT_VERDICT),
          .cell = at(launch.table),
          .from_id = at(id_slot(launch.order)),
          .sorted = at(position_slot(launch.target)),
          .id = at(id_slot(launch.target)),
          .sorted_count = at(SLOT_SORTED_COUNT),
          .tile_sum = at(SLOT_SCAN),
          .bucket_cursor = at(SLOT_BUCKET),
          .visible = at(SLOT_VISIBLE),
          .image = at(SLOT_IMAGE),
          .tile = at(SLOT_TILE),
          .drawn = at(SLOT_DRAWN),
          .cluster = at(SLOT_CLUSTER),
          .seen_left = at(SLOT_SEEN_LEFT),
          .cluster_list = at(SLOT_CLUSTER_LIST),
          .pyramid = at(SLOT_PYRAMID),
          .wide = at(SLOT_WIDE),
          .anchor = at(SLOT_ANCHOR),
          .flight = at(SLOT_FLIGHT),
          .since = at(SLOT_SINCE),
          .next_event = at(SLOT_NEXT_EVENT),
          .rest = at(SLOT_REST),
          .seen_list = at(SLOT_SEEN_LIST),
          .colour = at(SLOT_COLOUR),
          .fault = at(SLOT_FAULT),
          .grown = at(SLOT_GROWN),
          .near = at(SLOT_NEAR),
          .row = at(SLOT_ROW),
          .row_length = at(SLOT_ROW_LENGTH),
          .axis = {{at(SLOT_AXIS)}, {at(SLOT_AXIS + 1)}, {at(SLOT_AXIS + 2)}},
          .impulse = {at(SLOT_IMPULSE), at(SLOT_IMPULSE + 1), at(SLOT_IMPULSE + 2)}};
}

}  // namespace spherepair
