// SPDX-License-Identifier: MIT
#include "common/simulation/cluster_culling.h"

#include <algorithm>

#include "common/shared/cluster.h"

namespace spherepair {
namespace {

constexpr uint64_t visible_groups = 2112;                       // groups that run at once on the largest device
constexpr uint64_t clusters_groups = 4096, cull_groups = 8192;  // groups that fill it

// Names of a phase's times that differ from the kernels' names.
struct Stages {
  const char *pyramid, *cull, *clusters;
};
constexpr Stages near_stages{"draw_hiz_pyramid_near", "draw_cull_near", "draw_clusters_near"};
constexpr Stages far_stages{"draw_hiz_pyramid_far", "draw_cull_far", "draw_clusters_far"};
Stages stages_of(uint phase) { return phase == PHASE_NEAR ? near_stages : phase == PHASE_FAR ? far_stages : Stages{}; }

uint64_t pyramid_texels(const View& view) { return first_texel(3, view); }

}  // namespace

void ClusterCulling::upload() {
  boxes_of_.reset();
  visible_known_ = false;
}

// Makes the clusters' bounding boxes, which last until spheres move or are sorted again. Moving spheres need them for
// every image; cell borders then serve as boxes, which are less work and close enough.
void ClusterCulling::make_boxes(const Frame& frame, bool by_cells) {
  const View& view = frame.view;
  context_.buffers.grow(SLOT_CLUSTER_LIST, uint64_t(view.clusters) * 3 * sizeof(uint));
  const uint64_t boxes = uint64_t(view.clusters) + bundles_of(view);
  if (context_.buffers.grow(SLOT_CLUSTER, boxes * 2 * sizeof(vec4))) boxes_of_.reset();
  if (boxes_of_ == frame.order && boxes_version_ == context_.version) return;
  const uint64_t in_group = SERVICE_BLOCK / (by_cells ? 1 : BOUNDS_LANES);
  launch_drawing(context_, frame,
                 {Kernel::draw_bounds,
                  SERVICE_BLOCK,
                  {.by_cells = by_cells, .indices = frame.indices},
                  folded(ceil_div(view.clusters, in_group)),
                  frame.order});
  boxes_of_ = frame.order;
  boxes_version_ = context_.version;
}

void ClusterCulling::prepare_list() {
  if (visible_known_) return;
  context_.buffers.resize(SLOT_SEEN_LEFT, (context_.n / 8 + 1) * sizeof(uint));
  context_.buffers.resize(SLOT_SEEN_LIST, 2 * (context_.n + 1) * sizeof(uint));
  context_.buffers.write(SLOT_SEEN_LEFT, std::vector<uint>(context_.n / 8 + 1));
  context_.buffers.write(SLOT_DRAWN, std::vector<uint>(2 * DRAWN_WORDS));
  const uint64_t words = context_.buffers.bytes(SLOT_VISIBLE) / sizeof(uint);  // may be from larger images
  context_.buffers.write(SLOT_VISIBLE, std::vector<uint>(words, ~0u));
  visible_known_ = true;
}

// Draws one phase. Spheres of recent images are listed by sphere index, clusters are ranges of the frame's order.
void ClusterCulling::draw_phase(Frame& frame, uint phase) {
  frame.view.phase = phase;
  const bool previous = phase == PHASE_SEEN;
  const uint block = previous ? SEEN_BLOCK : CLUSTERS_BLOCK;
  const bool bundles = !previous && phase != PHASE_ALL && context_.n >= frame.options.bundles_from;
  launch_drawing(context_, frame,
                 {.kernel = previous ? Kernel::draw_previously_visible : Kernel::draw_clusters,
                  .block = block,
                  .variant = {.bundles = bundles, .indices = previous ? 0 : frame.indices},
                  .groups = folded(std::min(ceil_div(context_.n, block), previous ? visible_groups : clusters_groups)),
                  .order = previous ? Order::scene : frame.order,
                  .stage = stages_of(phase).clusters});
  if (frame.view.pass == PASS_DEPTH && phase != PHASE_NEAR) launch_tiles(context_, frame);  // else with the next
}

// Whether the eye is in the box of the dense cells. Near spheres then hide far ones, gaps or not.
bool ClusterCulling::eye_among_cells(const Frame& frame) const {
  const Params& params = context_.params;
  const auto within = [&](float eye, float origin, uint cells) {
    const float at = (eye - origin) * params.grid.cells_per_metre;
    return at >= 0 && at <= float(cells);
  };
  const vec4& eye = frame.view.eye;
  return sorter_.dense() && within(eye.x, params.grid.origin_x, params.grid.cells_x) &&
         within(eye.y, params.grid.origin_y, params.grid.cells_y) &&
         within(eye.z, params.grid.origin_z, params.grid.cells_z);
}

// Chooses the clusters of this phase by the depth pyramid of what is drawn already.
void ClusterCulling::cull(Frame& frame, uint phase) {
  View& view = frame.view;
  view.phase = phase;
  const uint64_t texels = uint64_t(texels_along(view.width, 2)) * texels_along(view.height, 2);
  Launch pyramid{Kernel::draw_hiz_pyramid, PYRAMID_BLOCK, {}, folded(texels)};
  pyramid.stage = stages_of(phase).pyramid;
  if (view.occlusion) launch_drawing(context_, frame, pyramid);
  if (phase == PHASE_ALL) return;
  Launch culling{Kernel::draw_cull, SERVICE_BLOCK, {}};
  culling.variant.bundles = context_.n >= frame.options.bundles_from;
  culling.groups = folded(std::min(ceil_div(view.clusters, SERVICE_BLOCK), cull_groups));
  culling.stage = stages_of(phase).cull;
  culling.texels = pyramid_texels(view);
  culling.variant.texture_table =
      culling.variant.bundles && context_.device.reads_texture(culling.kernel, context_.params, culling.texels, {});
  launch_drawing(context_, frame, culling);
}

std::vector<uint> ClusterCulling::phases_of(const Frame& frame, bool per_sphere) const {
  if (!frame.view.occlusion) return {PHASE_REST};
  if (per_sphere) return {PHASE_SEEN, PHASE_ALL};
  if (context_.n >= frame.options.defer_from && !eye_among_cells(frame)) return {PHASE_SEEN, PHASE_NEAR, PHASE_FAR};
  return {PHASE_SEEN, PHASE_REST};
}

void ClusterCulling::draw(Frame& frame, bool by_cells) {
  frame.view.clusters = uint(ceil_div(context_.n, CLUSTER));
  context_.buffers.grow(SLOT_PYRAMID, pyramid_texels(frame.view) * sizeof(uvec2));
  const bool per_sphere = frame.view.occlusion && context_.n < frame.options.cull_from;
  if (!per_sphere) make_boxes(frame, by_cells);
  const std::vector<uint> phases = phases_of(frame, per_sphere);
  for (const uint phase : phases) {
    if (phase != PHASE_SEEN) cull(frame, phase);
    draw_phase(frame, phase);
  }
  if (context_.device.capabilities().atomics_64) return;
  frame.view.pass = PASS_ID;
  restart_tiles(context_, frame);
  for (const uint phase : phases) draw_phase(frame, phase);
  launch_tiles(context_, frame);
}

}  // namespace spherepair
