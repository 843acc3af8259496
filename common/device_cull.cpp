// SPDX-License-Identifier: MIT
// Drawing by clusters: what the last picture showed is drawn first, a pyramid of depths is made of it, and of the rest
// only what that does not hide (hierarchical occlusion, two phases).
#include <algorithm>
#include <vector>

#include "cluster.h"
#include "device_backend.h"

namespace spherepair {
namespace {

constexpr uint cluster_groups = 8192;

uint64_t ceil_div(uint64_t a, uint64_t b) { return (a + b - 1) / b; }

uint levels_of(const View& view) {
  uint levels = 1;
  while (texels_along(view.width, levels - 1) * texels_along(view.height, levels - 1) > 1) ++levels;
  return levels;
}

}  // namespace

// Boxes of clusters last until spheres move or are sorted anew; without a last picture none was seen.
void DeviceBackend::make_clusters(const Params& params, Order order) {
  view_.clusters = uint(ceil_div(n_, CLUSTER));
  view_.levels = levels_of(view_);
  const auto keep = [&](uint slot, uint64_t bytes) {
    if (bytes_[slot] >= bytes) return false;
    make_buffer(slot, bytes);
    return true;
  };
  keep(SLOT_PYRAMID, uint64_t(first_texel(view_.levels, view_)) * sizeof(uint));
  keep(SLOT_CLUSTER_LIST, view_.clusters * sizeof(uint));
  if (keep(SLOT_CLUSTER_SEEN, view_.clusters * sizeof(uint))) {
    const std::vector<uint> none(view_.clusters);
    write(SLOT_CLUSTER_SEEN, none.data(), 0, none.size() * sizeof(uint));
  }
  if (keep(SLOT_CLUSTER, uint64_t(view_.clusters) * 2 * sizeof(vec4))) clustered_.reset();
  if (clustered_ == order) return;
  launch({Kernel::draw_bounds, CLUSTER, {}, folded(view_.clusters), order}, params);
  clustered_ = order;
}

void DeviceBackend::build_pyramid(const Params& params) {
  for (view_.level = 0; view_.level < view_.levels; ++view_.level) {
    const uint64_t texels = uint64_t(texels_along(view_.width, view_.level)) * texels_along(view_.height, view_.level);
    launch({Kernel::draw_pyramid, SERVICE_BLOCK, {}, folded(ceil_div(texels, SERVICE_BLOCK))}, params);
  }
}

void DeviceBackend::draw_phase(uint phase, const Params& params, Order order) {
  view_.phase = phase;
  const auto per_cluster = folded(ceil_div(view_.clusters, SERVICE_BLOCK));
  launch({Kernel::draw_cull, SERVICE_BLOCK, {}, per_cluster}, params);
  launch({Kernel::draw_clusters, CLUSTER, {}, {cluster_groups, 1, 1}, order}, params);
  draw_tiles(params, order);
}

void DeviceBackend::draw_clusters(const Params& params, Order order) {
  make_clusters(params, order);
  if (draw_options_.skip_hidden) {
    draw_phase(PHASE_SEEN, params, order);
    build_pyramid(params);
  }
  draw_phase(PHASE_REST, params, order);
  if (has_atomics_64()) return;
  view_.pass = PASS_ID;
  restart_lists();
  launch({Kernel::draw_clusters, CLUSTER, {}, {cluster_groups, 1, 1}, order}, params);
  draw_tiles(params, order);
}

}  // namespace spherepair
