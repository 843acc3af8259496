// SPDX-License-Identifier: MIT
#include "common/simulation/rasterizer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "common/backend/checks.h"
#include "common/scene/camera.h"

namespace spherepair {
namespace {

constexpr uint64_t least_tiles = 1 << 16, most_tiles = 1 << 22;  // initial size of the list of tiles

static_assert(sizeof(View) == 256);

}  // namespace

void Rasterizer::upload() {
  view_ = {};
  current_ = false;
  images_kept_ = 0;
  classes_set_ = false;
  culling_.upload();
}

void Rasterizer::enqueue(const View& view, const DrawOptions& options) {
  check_view(view);
  if (view.colour_by == COLOUR_BY_CLASS && !classes_set_)
    throw BackendError(fmt::format("{}: the spheres have no classes; call set_classes", context_.name()));
  if (options.reuse_unchanged && current(view, options)) {
    ++images_kept_;
    return;
  }
  current_ = complete_ = false;
  view_ = view;
  options_ = options;
  launch();
  current_ = true;
  version_ = context_.version;
}

void Rasterizer::run(const View& view, const DrawOptions& options) {
  if (search_.searched() && !search_.is_complete())
    throw BackendError(
        fmt::format("{}: the last collision step was only enqueued; call collide before draw", context_.name()));
  enqueue(view, options);
  while (!complete_ && grow_tiles()) launch();
  complete_ = true;
}

bool Rasterizer::current(const View& view, const DrawOptions& options) const {
  return current_ && version_ == context_.version && std::memcmp(&view, &view_, sizeof(View)) == 0 &&
         options == options_;
}

// Launches an image. Light needs dense cells: if the search used others, the spheres are sorted again, and the image
// does not use the search's order.
void Rasterizer::launch() {
  if (motion_.evaluate_positions()) search_.cleared();
  if (lit() && !sorter_.built_for_light()) {
    search_.leave_cells();
    sorter_.build_for_light();
  }
  search_.prepare_counts(draws_by_compute());
  if (view_.colour_by == COLOUR_BY_SPEED || view_.colour_by == COLOUR_BY_RADIUS) launch_colours();
  if (draws_by_compute()) return launch_compute();
  context_.pipeline().draw(options_.method, view_, context_.sphere_arrays(colour_slot(view_)), options_.transfer);
}

void Rasterizer::launch_colours() {
  if (view_.colour_by == COLOUR_BY_SPEED) motion_.evaluate_state();
  classes_set_ = false;
  context_.buffers.grow(SLOT_COLOUR, context_.n * sizeof(uint));
  Launch launch{Kernel::draw_colours, SERVICE_BLOCK, {}, folded(ceil_div(context_.n, SERVICE_BLOCK))};
  launch.view = &view_;
  if (context_.n > 0) context_.launch(launch);
}

Frame Rasterizer::make_frame() {
  Frame frame{.view = view_, .options = options_};
  frame.order = search_.order();
  frame.indices = sorter_.indices(frame.order);
  frame.culls = (options_.frustum_culling || options_.occlusion_culling) && context_.n >= options_.clusters_from;
  View& view = frame.view;
  view.tile_capacity = uint(context_.buffers.bytes(SLOT_TILE) / sizeof(uvec2));
  view.counting = options_.count;
  view.pass = PASS_DEPTH;
  view.phase = PHASE_SEEN;
  view.turn = culling_.turn();
  view.clusters = 0;
  view.occlusion = frame.culls && options_.occlusion_culling;
  view.lanes = frame.culls ? 1 : options_.lanes(context_.n);
  frame.may_have_tiles = motion_.moved() || !options_.skip_tile_launches || may_look_large(view, sorter_.plans().dense);
  pixels_kept_ = options_.keep_visible || lit();
  choose_pixels(frame, frame.culls || pixels_kept_ || frame.indices != 0);
  return frame;
}

// Chooses the buffer of pixels. Images alternate between two buffers, and then share only what they read, if nothing is
// counted or listed. Other images use the first buffer.
void Rasterizer::choose_pixels(Frame& frame, bool alone) {
  const bool shares = alone || !context_.device.capabilities().overlaps_images || !options_.overlap ||
                      frame.view.counting || frame.may_have_tiles;
  if (!shares) frame.unused = slots::tile | slots::drawn | slots::seen_left | slots::seen_list | slots::pyramid;
  frame.visible_slot = shares || frame_.visible_slot == SLOT_VISIBLE_ODD ? SLOT_VISIBLE : SLOT_VISIBLE_ODD;
  make_pixels(frame.visible_slot, pixels(frame.view) * 2 * sizeof(uint));
}

void Rasterizer::make_pixels(uint slot, uint64_t bytes) {
  if (context_.buffers.bytes(slot) >= bytes) return;
  pixels_clear_[slot] = 0;
  if (slot == SLOT_VISIBLE) culling_.forget_visible();
  context_.buffers.resize(slot, bytes);
}

// Draws with compute kernels. Unless the visible spheres are kept, their pixels and the counts are cleared for the next
// image.
void Rasterizer::launch_compute() {
  context_.buffers.grow(SLOT_IMAGE, pixels(view_) * sizeof(uint));
  context_.buffers.grow(SLOT_DRAWN, 2 * DRAWN_WORDS * sizeof(uint));
  context_.buffers.grow(SLOT_TILE, std::clamp(context_.n, least_tiles, most_tiles) * sizeof(uvec2));
  frame_ = make_frame();
  View& view = frame_.view;
  const bool by_cells =
      motion_.moved() && context_.equal_radii && search_.searched() && sorter_.built() && sorter_.dense();
  const uint64_t clear = std::exchange(pixels_clear_[frame_.visible_slot], 0);
  if (view.occlusion) culling_.prepare_list();
  if (pixels(view) > clear) launch_per_pixel(frame_, Kernel::draw_clear);
  if (context_.n > 0) frame_.culls ? culling_.draw(frame_, by_cells) : draw_all(frame_);
  view.pass = pixels_kept_ ? PASS_KEEP : PASS_DEPTH;
  launch_per_pixel(frame_, lit() ? Kernel::draw_light : Kernel::draw_resolve);
  if (pixels_kept_) {
    pixels_clear_ = {};
  } else {
    pixels_clear_[frame_.visible_slot] = std::max(clear, pixels(view));
  }
  if (view.occlusion) culling_.end_image();
}

// Draws in one pass with 64-bit atomics, else in a pass for depths and one for indices.
void Rasterizer::draw_all(Frame& frame) {
  for (const uint pass : {PASS_DEPTH, PASS_ID}) {
    if (pass == PASS_ID && context_.device.capabilities().atomics_64) return;
    frame.view.pass = pass;
    if (pass == PASS_ID) restart_tiles(context_, frame);
    const auto groups = folded(ceil_div(context_.n * frame.view.lanes, SERVICE_BLOCK));
    Launch spheres{Kernel::draw_spheres, SERVICE_BLOCK, {.indices = frame.indices}, groups, frame.order};
    spheres.unused = frame.unused | (frame.indices == 0 ? slots::count : slots::none);
    launch_drawing(context_, frame, spheres);
    launch_tiles(context_, frame);
  }
}

void Rasterizer::launch_per_pixel(const Frame& frame, Kernel kernel) {
  const bool one_each = kernel == Kernel::draw_light;
  const uint block = one_each ? SERVICE_BLOCK : PIXELS_BLOCK, each = one_each ? 1 : PIXELS_EACH;
  Launch launch{kernel, block, {}, folded(ceil_div(pixels(frame.view), block * each))};
  if (kernel == Kernel::draw_light) launch.variant.indices = sorter_.indices(sorter_.order());
  launch_drawing(context_, frame, launch);
}

void Rasterizer::require_drawn(bool by_compute) const {
  if (view_.width == 0) throw BackendError(fmt::format("{}: nothing is drawn yet; call draw first", context_.name()));
  if (!complete_)
    throw BackendError(fmt::format("{}: the last image was only enqueued; call draw for it", context_.name()));
  if (by_compute && !draws_by_compute())
    throw BackendError(fmt::format("{}: the last image was drawn by {}, which keeps no indices of spheres",
                                   context_.name(), draw_method_name(options_.method)));
}

bool Rasterizer::grow_tiles() {
  if (!draws_by_compute()) return false;
  uint tiles = 0;
  context_.buffers.read(SLOT_DRAWN, &tiles, statistics_offset() + DRAWN_TILES * sizeof(uint), sizeof(uint));
  tiles = std::max(tiles, frame_.tiles_of_depth_pass);
  if (tiles <= frame_.view.tile_capacity) return false;
  context_.buffers.resize(SLOT_TILE, (uint64_t(tiles) + tiles / 8) * sizeof(uvec2));
  return true;
}

std::vector<uint> Rasterizer::image() {
  require_drawn(false);
  if (!draws_by_compute()) return context_.pipeline().image();
  return context_.buffers.read<uint>(SLOT_IMAGE, pixels(view_));
}

std::vector<float> Rasterizer::depths() {
  require_drawn(false);
  if (draws_by_compute())
    throw BackendError(fmt::format("{}: the last image was drawn by compute; ask for visible()", context_.name()));
  return context_.pipeline().depths();
}

void Rasterizer::set_classes(std::span<const uint> classes) {
  check_classes(context_.name(), classes, context_.n);
  context_.buffers.grow(SLOT_COLOUR, context_.n * sizeof(uint));
  context_.buffers.write(SLOT_COLOUR, std::vector<uint>(classes.begin(), classes.end()));
  ++context_.version;
  classes_set_ = true;
}

bool Rasterizer::show(uint texture) {
  require_drawn(false);
  if (!draws_by_compute()) return context_.pipeline().show_drawn(texture);
  context_.device.flush();
  return context_.pipeline().show_pixels(context_.buffers.handles()[SLOT_IMAGE], {view_.width, view_.height}, texture);
}

std::vector<uvec2> Rasterizer::visible() {
  require_drawn(true);
  if (!options_.keep_visible)
    throw BackendError(fmt::format("{}: visible spheres were not kept; set keep_visible", context_.name()));
  return context_.buffers.read<uvec2>(SLOT_VISIBLE, pixels(view_));
}

DrawStatistics Rasterizer::statistics() {
  require_drawn(true);
  if (!options_.count) throw BackendError(fmt::format("{}: drawing was not counted; set count", context_.name()));
  std::vector<uint> drawn(DRAWN_WORDS);
  context_.buffers.read(SLOT_DRAWN, drawn.data(), statistics_offset(), drawn.size() * sizeof(uint));
  return {.drawn = uint64_t(drawn[DRAWN_SMALL]) + drawn[DRAWN_LARGE],
          .unseen = drawn[DRAWN_UNSEEN],
          .large = drawn[DRAWN_LARGE],
          .tiles = std::max(drawn[DRAWN_TILES], frame_.tiles_of_depth_pass),
          .hidden = drawn[DRAWN_HIDDEN],
          .undrawable = drawn[DRAWN_UNDRAWABLE],
          .clusters = frame_.view.clusters,
          .clusters_outside = drawn[DRAWN_CLUSTERS_OUTSIDE],
          .clusters_hidden = drawn[DRAWN_CLUSTERS_HIDDEN],
          .clusters_deferred = drawn[DRAWN_CLUSTERS_DEFERRED],
          .bundles_left_out = drawn[DRAWN_BUNDLES],
          .images_kept = images_kept_};
}

}  // namespace spherepair
