// SPDX-License-Identifier: MIT
#include "common/simulation/search/all_pairs.h"

#include <fmt/format.h>

#include <algorithm>

namespace spherepair {
namespace {

constexpr uint64_t pairs_per_dispatch = uint64_t(1) << 40;

// One group's share: `rows` spheres, each tested against `columns` spheres.
struct Share {
  Kernel kernel;
  uint64_t rows, columns;
};

Share share_of(const CollideOptions& options, uint64_t n, const std::string& backend) {
  const uint64_t block = options.block;
  switch (options.method) {
    case Method::collide_group:
      return {Kernel::collide_group, block, block};
    case Method::collide_tiled:
      return {Kernel::collide_tiled, block, n};
    case Method::collide_square:
      return {Kernel::collide_square, block, n};
    case Method::collide_triangle:
      return {Kernel::collide_triangle, block * SPHERES_PER_THREAD, n};
    default:
      throw std::invalid_argument(fmt::format("{}: the method {} runs on the backend cpu only; choose another --method",
                                              backend, method_name(options.method)));
  }
}

// Columns of row group k plus those of its mirror image: the same for every k. With one row group, its columns.
uint64_t columns_of_line(uint64_t n, uint64_t row_groups, uint64_t rows) {
  return row_groups == 1 ? n : 2 * n - (row_groups - 1) * rows;
}

}  // namespace

// Returns the columns a group of collide_triangle tests. Groups should outnumber the multiprocessors many times, but
// each should test enough columns to pay for loading its rows. In software groups run one after another.
uint default_columns(uint64_t n, bool software) {
  return uint(std::clamp<uint64_t>(ceil_div(n, 2048) * 8, software ? 64 : 8, 4096));
}

// Launches all pairs in slices. A driver may stop work that keeps the device for many seconds, so a slice takes about a
// second and is waited for. Each slice also stays within MAX_GROUPS.
void launch_all_pairs(DeviceContext& context, const CollideOptions& options, const Variant& variant) {
  if (options.method == Method::collide_tensor) return launch_tensor_pairs(context, variant);
  Params& params = context.params;
  const Share share = share_of(options, std::max<uint64_t>(context.n, 1), context.name());
  const bool mirrored = share.kernel == Kernel::collide_triangle;  // a line of the launch is two row groups
  const uint64_t row_groups = ceil_div(std::max<uint64_t>(context.n, 1), share.rows);
  const uint64_t groups = mirrored ? ceil_div(row_groups, 2) : row_groups;
  const uint64_t slice = std::clamp<uint64_t>(pairs_per_dispatch / (share.rows * share.columns), 1, MAX_GROUPS);
  for (uint64_t first = 0; first < groups; first += slice) {
    const uint part = uint(std::min(slice, groups - first));
    Launch launching{share.kernel, options.block, variant, {part, 1, 1}};
    if (share.kernel == Kernel::collide_square) {
      launching.groups = {part, uint(std::min<uint64_t>(groups, MAX_GROUPS)), uint(ceil_div(groups, MAX_GROUPS))};
    } else if (mirrored) {
      const uint64_t columns = columns_of_line(context.n, row_groups, share.rows);
      const uint64_t least = ceil_div(columns, MAX_GROUPS - 1);
      params.search.columns_per_group = uint(std::clamp<uint64_t>(params.search.columns_per_group, least, context.n));
      launching.groups = {uint(ceil_div(columns, params.search.columns_per_group) + 1), part, 1};
    }
    params.first_group = uint(first);
    context.launch(launching);
    if (groups > slice) context.device.wait();
  }
  params.first_group = 0;
}

}  // namespace spherepair
