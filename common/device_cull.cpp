// SPDX-License-Identifier: MIT
// Drawing by clusters: what the last picture showed is drawn first, a pyramid of depths is made of it, and of the rest
// only what that does not hide is drawn (hierarchical occlusion, two phases).
#include <algorithm>
#include <vector>

#include "cluster.h"
#include "device_backend.h"

namespace spherepair {
namespace {

constexpr uint64_t cluster_groups = 4096;  // that fill a large device

uint64_t ceil_div(uint64_t a, uint64_t b) { return (a + b - 1) / b; }

}  // namespace

// Boxes of clusters last until spheres move or are sorted anew; without a last picture none was seen.
void DeviceBackend::make_clusters(const Params& params, Order order) {
  view_.clusters = uint(ceil_div(n_, CLUSTER));
  const auto keep = [&](uint slot, uint64_t bytes) {
    if (bytes_[slot] >= bytes) return false;
    make_buffer(slot, bytes);
    return true;
  };
  keep(SLOT_PYRAMID, (first_texel(1, view_) + level_1_texels()) * sizeof(uint));
  keep(SLOT_CLUSTER_LIST, 3 * uint64_t(view_.clusters) * sizeof(uint));
  if (keep(SLOT_CLUSTER_SEEN, view_.clusters * sizeof(uint))) seen_known_ = false;
  if (!seen_known_) forget_seen();
  if (keep(SLOT_CLUSTER, uint64_t(view_.clusters) * 2 * sizeof(vec4))) clustered_.reset();
  if (clustered_ == order) return;
  launch({Kernel::draw_bounds, CLUSTER, {}, folded(view_.clusters), order}, params);
  clustered_ = order;
}

void DeviceBackend::forget_seen() {
  const std::vector<uint> none(view_.clusters);
  write(SLOT_CLUSTER_SEEN, none.data(), 0, none.size() * sizeof(uint));
  const uint no_entries[] = {0, 0};
  write(SLOT_DRAWN, no_entries, DRAWN_SEEN * sizeof(uint), sizeof(no_entries));
  seen_known_ = true;
}

uint64_t DeviceBackend::level_1_texels() const {
  return uint64_t(texels_along(view_.width, 1)) * texels_along(view_.height, 1);
}

void DeviceBackend::draw_phase(uint phase, const Params& params, Order order) {
  view_.phase = phase;
  launch({Kernel::draw_clusters, CLUSTER, {}, folded(std::min<uint64_t>(view_.clusters, cluster_groups)), order},
         params);
  if (view_.pass == PASS_DEPTH || phase == PHASE_REST) draw_tiles(params, order);  // the second pass draws all at once
}

void DeviceBackend::draw_clusters(const Params& params, Order order) {
  make_clusters(params, order);
  if (draw_options_.skip_hidden) {
    draw_phase(PHASE_SEEN, params, order);
    launch({Kernel::draw_pyramid, SERVICE_BLOCK, {}, folded(level_1_texels())}, params);
  }
  launch({Kernel::draw_cull, SERVICE_BLOCK, {}, folded(ceil_div(view_.clusters, SERVICE_BLOCK))}, params);
  draw_phase(PHASE_REST, params, order);
  if (!has_atomics_64()) {
    view_.pass = PASS_ID;
    restart_lists();
    if (draw_options_.skip_hidden) draw_phase(PHASE_SEEN, params, order);
    draw_phase(PHASE_REST, params, order);
  }
  if (draw_options_.skip_hidden) view_.turn = 1 - view_.turn;
}

}  // namespace spherepair
