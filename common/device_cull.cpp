// SPDX-License-Identifier: MIT
// Drawing by clusters: the spheres that the last pictures showed are drawn first, a pyramid of depths is made of them,
// and of the rest only what that does not hide is drawn (hierarchical occlusion, two phases).
#include <algorithm>
#include <vector>

#include "cluster.h"
#include "device_backend.h"

namespace spherepair {
namespace {

constexpr uint64_t batch_groups = 4096;  // that fill a large device

uint64_t ceil_div(uint64_t a, uint64_t b) { return (a + b - 1) / b; }

}  // namespace

// Boxes of clusters last until spheres move or are sorted anew.
void DeviceBackend::make_clusters(const Params& params, Order order) {
  view_.clusters = uint(ceil_div(n_, CLUSTER));
  const auto keep = [&](uint slot, uint64_t bytes) {
    if (bytes_[slot] >= bytes) return false;
    make_buffer(slot, bytes);
    return true;
  };
  keep(SLOT_PYRAMID, (first_texel(1, view_) + level_1_texels()) * sizeof(uint));
  keep(SLOT_CLUSTER_LIST, uint64_t(view_.clusters) * sizeof(uint));
  if (keep(SLOT_CLUSTER, uint64_t(view_.clusters) * 2 * sizeof(vec4))) clustered_.reset();
  if (clustered_ == order) return;
  launch(
      {Kernel::draw_bounds, SERVICE_BLOCK, {}, folded(ceil_div(n_, CLUSTER * (SERVICE_BLOCK / BOUNDS_LANES))), order},
      params);
  clustered_ = order;
}

// What the last picture showed is in SLOT_VISIBLE. Of another scene it is cleared, and nothing was seen.
void DeviceBackend::make_seen_list(const Params& params) {
  const uint together = view_.occlusion;
  if (seen_known_ == together) return;
  const uint64_t all = n_ / together + 1;
  const std::vector<uint> none(all / 8 + 1), no_entries(DRAWN_WORDS);
  make_buffer(SLOT_SEEN_LEFT, none.size() * sizeof(uint));
  make_buffer(SLOT_SEEN_LIST, 2 * all * sizeof(uint));
  write(SLOT_SEEN_LEFT, none.data(), 0, none.size() * sizeof(uint));
  write(SLOT_DRAWN, no_entries.data(), 0, no_entries.size() * sizeof(uint));
  view_.occlusion = 0;
  launch_per_pixel(Kernel::draw_clear, PIXELS_EACH, params);
  view_.occlusion = seen_known_ = together;
}

uint64_t DeviceBackend::level_1_texels() const {
  return uint64_t(texels_along(view_.width, 1)) * texels_along(view_.height, 1);
}

// Spheres that were seen are known by their numbers, the clusters are of places.
void DeviceBackend::draw_phase(uint phase, const Params& params, Order order) {
  view_.phase = phase;
  Params by_number = params;
  by_number.in_cells = false;
  const bool seen = phase == PHASE_SEEN;
  const uint64_t most = seen ? ceil_div(n_ * view_.lanes, BATCH) : ceil_div(view_.clusters, BATCH / CLUSTER);
  launch({seen ? Kernel::draw_seen : Kernel::draw_clusters,
          BATCH,
          {},
          folded(std::min(most, batch_groups)),
          seen ? Order::scene : order},
         seen ? by_number : params);
  if (view_.pass == PASS_DEPTH || !seen) draw_tiles(params);  // the second pass draws all at once
}

void DeviceBackend::draw_clusters(const Params& params, Order order) {
  make_clusters(params, order);
  if (view_.occlusion) {
    draw_phase(PHASE_SEEN, params, order);
    launch({Kernel::draw_pyramid, SERVICE_BLOCK, {}, folded(level_1_texels())}, params);
  }
  launch({Kernel::draw_cull, SERVICE_BLOCK, {}, folded(ceil_div(view_.clusters, SERVICE_BLOCK))}, params);
  draw_phase(PHASE_REST, params, order);
  if (has_atomics_64()) return;
  view_.pass = PASS_ID;
  restart_lists();
  if (view_.occlusion) draw_phase(PHASE_SEEN, params, order);
  draw_phase(PHASE_REST, params, order);
}

}  // namespace spherepair
