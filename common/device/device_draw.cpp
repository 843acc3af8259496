// SPDX-License-Identifier: MIT
// Drawing on GLSL and CUDA: which kernels run, and what happens when the list of tiles is too short.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "common/device/device_backend.h"
#include "common/scene/camera.h"

namespace spherepair {
namespace {

constexpr const char* tiles_stage[] = {"draw_tiles_seen", "draw_tiles_rest", nullptr, "draw_tiles_far",
                                       "draw_tiles_rest"};
constexpr uint tile_groups = 1024;                               // that fill a large device
constexpr uint64_t least_tiles = 1 << 16, most_tiles = 1 << 22;  // that the list has room for at first

static_assert(sizeof(View) == 208);

uint64_t ceil_div(uint64_t a, uint64_t b) { return (a + b - 1) / b; }
uint64_t pixels(const View& view) { return uint64_t(view.width) * view.height; }

}  // namespace

void DeviceBackend::make_draw_buffers() {
  const auto keep = [&](uint slot, uint64_t bytes) {
    if (bytes_[slot] < bytes) make_buffer(slot, bytes);
  };
  keep(SLOT_IMAGE, pixels(view_) * sizeof(uint));
  keep(SLOT_DRAWN, 2 * DRAWN_WORDS * sizeof(uint));
  keep(SLOT_TILE, std::clamp(n_, least_tiles, most_tiles) * sizeof(uvec2));
}

void DeviceBackend::make_visible_buffer() {
  const uint64_t bytes = pixels(view_) * 2 * sizeof(uint);
  if (bytes_[visible_slot_] >= bytes) return;
  pixels_clear_[visible_slot_] = 0;
  if (visible_slot_ == SLOT_VISIBLE) seen_known_ = false;
  make_buffer(visible_slot_, bytes);
}

// One pass for 64-bit atomics, else one for each word of what is visible.
void DeviceBackend::draw_all(const Params& params, Order order) {
  for (const uint pass : {PASS_DEPTH, PASS_ID}) {
    if (pass == PASS_ID && has_atomics_64()) return;
    view_.pass = pass;
    if (pass == PASS_ID) restart_lists();
    Launch spheres{Kernel::draw_spheres, SERVICE_BLOCK, {}, folded(ceil_div(n_ * view_.lanes, SERVICE_BLOCK)), order};
    if (overlaps_) spheres.overlaps_previous = Kernel::draw_resolve;
    launch(spheres, params);
    draw_tiles(params);
  }
}

// Whether the box of any sphere's pixels may be large (is_large). As they were uploaded, all lie in the dense cells'
// box, so none looks larger than the largest would in its nearest corner, at the picture's edge.
bool DeviceBackend::may_be_large() const {
  if (moved_ || !draw_options_.skip_tile_launches) return true;
  const GridPlan& plan = plans_.dense;
  const double eye[] = {view_.eye.x, view_.eye.y, view_.eye.z};
  const double forward[] = {view_.forward.x, view_.forward.y, view_.forward.z};
  const double radius = plan.largest_radius;
  double close = 0, coordinates = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = plan.origin[axis] - eye[axis], high = low + plan.size[axis] * double(plan.side);
    close += std::min(forward[axis] * low, forward[axis] * high);
    coordinates += std::abs(eye[axis]) + std::max(std::abs(low), std::abs(high));
  }
  close -= coordinates * 0x1p-20;  // more than rounding takes from a place
  if (!(close > 1.01 * radius)) return true;
  const double aside = std::max(view_.half_x, view_.half_y), beyond = std::max(view_.norm_x, view_.norm_y) * radius;
  const double pixels = 2 * radius * view_.focal * ((1 + aside) * close + beyond) / (close * close - radius * radius);
  const uint most = view_.lanes == LANES ? SHARE_AT_MOST : WALK_AT_MOST;
  return !(1.01 * pixels + 2 <= most);
}

void DeviceBackend::draw_tiles(const Params& params) {
  if (!may_be_large()) return;
  Launch tiles{Kernel::draw_tiles, SERVICE_BLOCK, {}, {tile_groups, 1, 1}};
  if (view_.occlusion) tiles.stage = tiles_stage[view_.phase];
  launch(tiles, params);
}

// The second pass lists the tiles again, of fewer spheres where more is drawn by then: the first says how many.
void DeviceBackend::restart_lists() {
  const uint none[] = {0, 0};
  read(SLOT_DRAWN, &first_pass_tiles_, DRAWN_TILES * sizeof(uint), sizeof(uint));
  write(SLOT_DRAWN, none, DRAWN_TILES * sizeof(uint), sizeof(none));
}

void DeviceBackend::launch_per_pixel(Kernel kernel, const Params& params) {
  const bool alone = kernel == Kernel::draw_light;
  const uint block = alone ? SERVICE_BLOCK : PIXELS_BLOCK, each = alone ? 1 : PIXELS_EACH;
  launch({kernel, block, {}, folded(ceil_div(pixels(view_), block * each))}, params);
}

// Where nothing is counted or listed, pictures by turns in two buffers have nothing in common but what they read.
// Others stand in the first.
void DeviceBackend::choose_visible_slot(bool alone) {
  const bool shares = alone || !overlaps_launches() || !draw_options_.overlap || view_.counting || may_be_large();
  overlaps_ = !shares;
  visible_slot_ = shares || visible_slot_ == SLOT_VISIBLE_ODD ? SLOT_VISIBLE : SLOT_VISIBLE_ODD;
  make_visible_buffer();
}

// `keep`: what the pixels show is to be read. Else they, and the counts, are ready for the next picture in the end.
void DeviceBackend::launch_rasteriser(bool keep) {
  const Order order = collided_ && cells_built_ ? order_ : Order::scene;
  Params params = params_;
  params.in_cells = indices_of(order);
  view_.tile_capacity = uint(bytes_[SLOT_TILE] / sizeof(uvec2));
  view_.counting = draw_options_.count;
  view_.pass = PASS_DEPTH;
  first_pass_tiles_ = 0;
  view_.phase = PHASE_SEEN;
  view_.turn = lists_turn_;
  const bool culls =
      (draw_options_.frustum_culling || draw_options_.occlusion_culling) && n_ >= draw_options_.clusters_from;
  view_.occlusion = culls && draw_options_.occlusion_culling;
  view_.lanes = culls ? 1 : draw_options_.lanes(n_);
  pixels_kept_ = keep || view_.lighting;
  choose_visible_slot(culls || pixels_kept_ || params.in_cells);
  const uint64_t clear = std::exchange(pixels_clear_[visible_slot_], 0);
  if (view_.occlusion) make_seen_list();
  if (pixels(view_) > clear) launch_per_pixel(Kernel::draw_clear, params);
  if (n_ > 0) culls ? draw_clusters(params, order) : draw_all(params, order);
  view_.pass = pixels_kept_ ? PASS_KEEP : PASS_DEPTH;
  launch_per_pixel(view_.lighting ? Kernel::draw_light : Kernel::draw_resolve, params);
  if (pixels_kept_) pixels_clear_ = {};
  if (!pixels_kept_) pixels_clear_[visible_slot_] = std::max(clear, pixels(view_));
  if (view_.occlusion) lists_turn_ = 1 - lists_turn_;
}

void DeviceBackend::ready_to_draw(bool sorted) {
  require_scene("draw");
  evaluate_positions();
  if (!collided_ && !cleared_) launch_clear(Order::scene);
  cleared_ |= !collided_;
  if (collided_) resolve_undecided();
  if (!collided_ || !counts_sorted_ || sorted) return;
  launch({Kernel::draw_unsort_counts, SERVICE_BLOCK, {}, folded(ceil_div(n_, SERVICE_BLOCK))}, params_);
  counts_sorted_ = false;
}

void DeviceBackend::launch_draw() {
  const bool compute = draw_options_.method == DrawMethod::compute;
  ready_to_draw(compute);
  if (!compute) return draw_by_pipeline(draw_options_.method);
  make_draw_buffers();
  launch_rasteriser();
}

void DeviceBackend::draw(const View& view, const DrawOptions& options) {
  require_scene("draw");
  check_view(view);
  if (std::ranges::count(draw_methods(), options.method) == 0)
    throw std::invalid_argument(
        fmt::format("{}: the method of drawing {} runs on OpenGL only", info().name, draw_method_name(options.method)));
  if (view.lighting != 0 &&
      !(collided_ && options_.method == Method::collide_grid && n_ > 1 && planned_ == Cells::dense))
    throw std::invalid_argument(fmt::format(
        "{}: occlusion and shadows need the dense cells of collide_grid; collide with them first", info().name));
  if (options.reuse_unchanged && image_current_ && same_image(view, options)) {
    ++images_kept_;
    return;
  }
  image_current_ = false;
  view_ = asked_ = view;
  draw_options_ = options;
  launch_draw();
  image_current_ = true;
}

bool DeviceBackend::same_image(const View& view, const DrawOptions& options) const {
  return std::memcmp(&view, &asked_, sizeof(View)) == 0 && options == draw_options_;
}

void DeviceBackend::require_drawn(bool by_compute) const {
  if (view_.width == 0) throw BackendError(fmt::format("{}: nothing is drawn yet; call draw first", info().name));
  if (by_compute && draw_options_.method != DrawMethod::compute)
    throw BackendError(fmt::format("{}: the last picture was drawn by {}, which keeps no numbers of spheres",
                                   info().name, draw_method_name(draw_options_.method)));
}

// Lists of the collision step that were too short mean wrong colours, so they are looked at too.
bool DeviceBackend::grow_draw_lists() {
  bool grown = false;
  if (draw_options_.method == DrawMethod::compute) {
    uint tiles = 0;
    read(SLOT_DRAWN, &tiles, drawn_results() + DRAWN_TILES * sizeof(uint), sizeof(uint));
    tiles = std::max(tiles, first_pass_tiles_);
    grown = tiles > view_.tile_capacity;
    if (grown) make_buffer(SLOT_TILE, (uint64_t(tiles) + tiles / 8) * sizeof(uvec2));
  }
  if (!collided_) return grown;
  const std::vector<uint> words = read_summary();
  if (!grow_lists(words[SUM_DEFERRED], words[SUM_LISTED])) return grown;
  run_collide();
  return true;
}

void DeviceBackend::finish_draw() {
  while (grow_draw_lists()) launch_draw();
  image_current_ = true;
}

std::vector<uint> DeviceBackend::image() {
  require_drawn(false);
  finish_draw();
  if (draw_options_.method != DrawMethod::compute) return pipeline_image();
  std::vector<uint> image(pixels(view_));
  read(SLOT_IMAGE, image.data(), 0, image.size() * sizeof(uint));
  return image;
}

std::vector<uvec2> DeviceBackend::visible() {
  require_drawn(true);
  finish_draw();
  while (!pixels_kept_) {  // the picture is drawn again
    launch_rasteriser(true);
    finish_draw();  // which may have to draw it with longer lists
  }
  std::vector<uvec2> visible(pixels(view_));
  read(SLOT_VISIBLE, visible.data(), 0, visible.size() * sizeof(uvec2));
  return visible;
}

DrawStatistics DeviceBackend::draw_statistics() {
  require_drawn(true);
  if (!draw_options_.count) throw BackendError(fmt::format("{}: drawing was not counted; set count", info().name));
  finish_draw();
  std::vector<uint> drawn(DRAWN_WORDS);
  read(SLOT_DRAWN, drawn.data(), drawn_results(), drawn.size() * sizeof(uint));
  return {.drawn = uint64_t(drawn[DRAWN_SMALL]) + drawn[DRAWN_LARGE],
          .unseen = drawn[DRAWN_UNSEEN],
          .large = drawn[DRAWN_LARGE],
          .tiles = std::max(drawn[DRAWN_TILES], first_pass_tiles_),
          .hidden = drawn[DRAWN_HIDDEN],
          .undrawable = drawn[DRAWN_UNDRAWABLE],
          .clusters = view_.clusters,
          .clusters_outside = drawn[DRAWN_CLUSTERS_OUTSIDE],
          .clusters_hidden = drawn[DRAWN_CLUSTERS_HIDDEN],
          .clusters_deferred = drawn[DRAWN_CLUSTERS_DEFERRED],
          .bundles_left_out = drawn[DRAWN_BUNDLES],
          .images_kept = images_kept_};
}

}  // namespace spherepair
