// SPDX-License-Identifier: MIT
#include <algorithm>

#include "common/shared/tensor_form.h"
#include "common/simulation/search/all_pairs.h"

namespace spherepair {
namespace {

constexpr uint64_t tiles_per_dispatch = (uint64_t(1) << 40) / (TENSOR_ROWS * TENSOR_COLUMNS);  // 2^40 pairs

}  // namespace

// Launches groups that all run at once and end together: each takes an equal number of consecutive tiles. Work that a
// driver may stop goes out in slices, each waited for.
void launch_tensor_pairs(DeviceContext& context, const Variant& variant) {
  Params& params = context.params;
  const uint64_t padded = ceil_div(context.n, TENSOR_ROWS) * TENSOR_ROWS;
  context.buffers.grow(SLOT_SPLIT, padded * sizeof(TensorForm));
  context.buffers.grow(SLOT_SCAN, 2 * TENSOR_BOUNDS_GROUPS * sizeof(vec4));
  const uint64_t at_once = context.device.capabilities().tensor_groups, tiles = tensor_tiles(context.n);
  const uint block = context.device.capabilities().tensor_block;
  const uint64_t share = std::max<uint64_t>(ceil_div(std::min(tiles, tiles_per_dispatch), at_once), 1);
  const uint64_t groups = ceil_div(tiles, share);
  params.search.tiles_per_group = uint(share);  // set before the first launch: parameters that change are sent again
  context.launch({Kernel::tensor_bounds, SERVICE_BLOCK, {}, {TENSOR_BOUNDS_GROUPS, 1, 1}});
  context.launch(
      {Kernel::tensor_forms, SERVICE_BLOCK, {}, folded(padded / SERVICE_BLOCK), Order::scene, Order::buckets});
  for (uint64_t first = 0; first < groups; first += at_once) {
    params.first_group = uint(first);
    const uint part = uint(std::min(at_once, groups - first));
    context.launch({Kernel::collide_tensor, block, variant, {part, 1, 1}, Order::scene, Order::buckets});
    if (groups > at_once) context.device.wait();
  }
  params.first_group = 0;
}

}  // namespace spherepair
