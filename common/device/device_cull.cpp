// SPDX-License-Identifier: MIT
// Drawing by clusters: the spheres that the last pictures showed are drawn first, a pyramid of depths is made of them,
// and of the rest only what that does not hide is drawn (hierarchical occlusion, two phases). Where the camera moved,
// there are gaps between the spheres seen; of many spheres the near ones fill them before the far ones are looked at.
#include <algorithm>
#include <vector>

#include "common/device/device_backend.h"
#include "common/shared/cluster.h"

namespace spherepair {
namespace {

constexpr uint64_t seen_groups = 2112;                          // that run at once on the largest device
constexpr uint64_t clusters_groups = 4096, cull_groups = 8192;  // that fill it

// What the times of a phase are called where not by the kernels' names.
struct Stages {
  const char *pyramid, *cull, *clusters;
};
constexpr Stages near_stages{"draw_hiz_pyramid_near", "draw_cull_near", "draw_clusters_near"};
constexpr Stages far_stages{"draw_hiz_pyramid_far", "draw_cull_far", "draw_clusters_far"};
Stages stages_of(uint phase) { return phase == PHASE_NEAR ? near_stages : phase == PHASE_FAR ? far_stages : Stages{}; }

uint64_t ceil_div(uint64_t a, uint64_t b) { return (a + b - 1) / b; }

}  // namespace

uint64_t DeviceBackend::pyramid_texels() const { return first_texel(3, view_); }

// Boxes of clusters last until spheres move or are sorted anew. Of those that move they are made with every picture,
// and the borders of cells, which are less work, hold them closely enough.
void DeviceBackend::make_clusters(const Params& params, Order order) {
  const auto keep = [&](uint slot, uint64_t bytes) {
    if (bytes_[slot] >= bytes) return false;
    make_buffer(slot, bytes);
    return true;
  };
  keep(SLOT_CLUSTER_LIST, uint64_t(view_.clusters) * 3 * sizeof(uint));
  const uint64_t boxes = uint64_t(view_.clusters) + bundles_of(view_);
  if (keep(SLOT_CLUSTER, boxes * 2 * sizeof(vec4))) clustered_.reset();
  if (clustered_ == order) return;
  const Variant variant = {.by_cells = moved_ && equal_radii_ && collided_ && cells_built_ && planned_ == Cells::dense};
  const uint64_t in_group = SERVICE_BLOCK / (variant.by_cells ? 1 : BOUNDS_LANES);
  launch({Kernel::draw_bounds, SERVICE_BLOCK, variant, folded(ceil_div(view_.clusters, in_group)), order}, params);
  clustered_ = order;
}

// What the last picture showed is listed. Of another scene it is cleared, and nothing was seen.
void DeviceBackend::make_seen_list() {
  if (seen_known_) return;
  const std::vector<uint> none(n_ / 8 + 1), no_entries(2 * DRAWN_WORDS);
  make_buffer(SLOT_SEEN_LEFT, none.size() * sizeof(uint));
  make_buffer(SLOT_SEEN_LIST, 2 * (n_ + 1) * sizeof(uint));
  write(SLOT_SEEN_LEFT, none.data(), 0, none.size() * sizeof(uint));
  write(SLOT_DRAWN, no_entries.data(), 0, no_entries.size() * sizeof(uint));
  const std::vector<uint> no_pixels(bytes_[SLOT_VISIBLE] / sizeof(uint), ~0u);  // of larger pictures, too
  write(SLOT_VISIBLE, no_pixels.data(), 0, no_pixels.size() * sizeof(uint));
  seen_known_ = true;
}

// Spheres that were seen are known by their numbers, the clusters are of places.
void DeviceBackend::draw_phase(uint phase, const Params& params, Order order) {
  view_.phase = phase;
  Params by_number = params;
  by_number.in_cells = false;
  const bool seen = phase == PHASE_SEEN;
  const uint block = seen ? SEEN_BLOCK : CLUSTERS_BLOCK;
  const bool bundles = !seen && phase != PHASE_ALL && n_ >= draw_options_.bundles_from;
  launch({.kernel = seen ? Kernel::draw_previously_visible : Kernel::draw_clusters,
          .block = block,
          .variant = {.bundles = bundles},
          .groups = folded(std::min(ceil_div(n_, block), seen ? seen_groups : clusters_groups)),
          .order = seen ? Order::scene : order,
          .stage = stages_of(phase).clusters},
         seen ? by_number : params);
  if (view_.pass == PASS_DEPTH && phase != PHASE_NEAR) draw_tiles(params);  // those left are drawn with the next
}

// In the box of the dense cells: what is near then hides what is far, gaps or not.
bool DeviceBackend::eye_among_cells() const {
  const auto within = [this](float eye, float origin, uint cells) {
    const float sorted_index = (eye - origin) * params_.cells_per_metre;
    return sorted_index >= 0 && sorted_index <= float(cells);
  };
  return planned_ == Cells::dense && within(view_.eye.x, params_.origin_x, params_.cells_x) &&
         within(view_.eye.y, params_.origin_y, params_.cells_y) &&
         within(view_.eye.z, params_.origin_z, params_.cells_z);
}

// Which clusters are to be drawn in this phase, by the pyramid of what is drawn already.
void DeviceBackend::cull(uint phase, const Params& params) {
  view_.phase = phase;
  const Stages stages = stages_of(phase);
  const uint64_t texels = uint64_t(texels_along(view_.width, 2)) * texels_along(view_.height, 2);
  Launch pyramid{Kernel::draw_hiz_pyramid, PYRAMID_BLOCK, {}, folded(texels)};
  pyramid.stage = stages.pyramid;
  if (view_.occlusion) launch(pyramid, params);
  if (phase == PHASE_ALL) return;
  const uint64_t groups = std::min(ceil_div(view_.clusters, SERVICE_BLOCK), cull_groups);
  const bool bundles = n_ >= draw_options_.bundles_from;
  const Variant variant = {.texture_table = bundles && takes_texture(Kernel::draw_cull, {}), .bundles = bundles};
  Launch culls{Kernel::draw_cull, SERVICE_BLOCK, variant, folded(groups)};
  culls.stage = stages.cull;
  launch(culls, params);
}

void DeviceBackend::draw_clusters(const Params& params, Order order) {
  view_.clusters = uint(ceil_div(n_, CLUSTER));
  if (bytes_[SLOT_PYRAMID] < pyramid_texels() * sizeof(uvec2))
    make_buffer(SLOT_PYRAMID, pyramid_texels() * sizeof(uvec2));
  const bool all = view_.occlusion && n_ < draw_options_.cull_from;
  if (!all) make_clusters(params, order);
  std::vector<uint> phases;
  if (view_.occlusion) phases = {PHASE_SEEN};
  if (all) {
    phases.push_back(PHASE_ALL);
  } else if (view_.occlusion && n_ >= draw_options_.defer_from && !eye_among_cells()) {
    phases.insert(phases.end(), {PHASE_NEAR, PHASE_FAR});
  } else {
    phases.push_back(PHASE_REST);
  }
  for (const uint phase : phases) {
    if (phase != PHASE_SEEN) cull(phase, params);
    draw_phase(phase, params, order);
  }
  if (has_atomics_64()) return;
  view_.pass = PASS_ID;
  restart_lists();
  for (const uint phase : phases) draw_phase(phase, params, order);
  draw_tiles(params);
}

}  // namespace spherepair
