// SPDX-License-Identifier: MIT
#include "common/simulation/simulation.h"

#include <fmt/format.h>

#include <algorithm>

namespace spherepair {

Simulation::Simulation(std::unique_ptr<Device> device)
    : device_(std::move(device)),
      context_(*device_),
      motion_(context_),
      sorter_(context_),
      search_(context_, motion_, sorter_),
      rasterizer_(context_, motion_, sorter_, search_),
      probe_(context_) {}

void Simulation::require_scene(const char* what) const {
  if (!context_.buffers.bytes(SLOT_POSITION))
    throw BackendError(fmt::format("{}: {} needs a scene; call upload first", info().name, what));
}

void Simulation::begin(const Scene& scene, const MotionState* saved) {
  check_scene(scene);
  finish();
  context_.n = scene.size();
  context_.buffers.set_spheres(scene.size());
  context_.equal_radii = scene.equal_radii;
  ++context_.version;
  device_->work = {.plans = 1};
  context_.params = {};
  context_.params.n = uint(scene.size());
  context_.params.radius = common_radius(scene);
  sorter_.upload(scene);
  motion_.upload(scene, saved);
  search_.upload(scene);
  rasterizer_.upload();
  probe_.upload();
}

void Simulation::move() {
  require_scene("move");
  const bool sorted = search_.counts_sorted();
  const bool overlap = sorted && !search_.results_clear();
  const bool cleared = motion_.step(!sorted, overlap ? context_.overlaps_search(search_.options().api) : std::nullopt);
  ++context_.version;
  search_.moved(cleared);
  sorter_.moved();
}

void Simulation::evaluate_positions() {
  require_scene("evaluate_positions");
  search_.evaluate_positions();
}

void Simulation::evaluate_state() {
  require_scene("evaluate_state");
  motion_.evaluate_state();
}

Backend::State Simulation::state() {
  require_scene("state");
  if (!motion_.state_current())
    throw BackendError(fmt::format("{}: the state is that of an earlier step; call evaluate_state", info().name));
  return motion_.state();
}

MotionState Simulation::save() {
  evaluate_state();
  return motion_.save();
}

MethodChoice Simulation::choice(const CollideOptions& options) const {
  require_scene("choice");
  return search_.choice(options);
}

void Simulation::collide(const CollideOptions& options) {
  require_scene("collide");
  search_.enqueue(options);
  search_.complete();
}

void Simulation::enqueue_collide(const CollideOptions& options) {
  require_scene("collide");
  search_.enqueue(options);
}

std::vector<DrawMethod> Simulation::draw_methods() const {
  if (device_->pipeline()) return {all_draw_methods().begin(), all_draw_methods().end()};
  return {DrawMethod::compute};
}

void Simulation::require_method(DrawMethod method) const {
  require_scene("draw");
  if (std::ranges::count(draw_methods(), method) == 0)
    throw std::invalid_argument(
        fmt::format("{}: the method of drawing {} runs on OpenGL only", info().name, draw_method_name(method)));
}

void Simulation::draw(const View& view, const DrawOptions& options) {
  require_method(options.method);
  rasterizer_.run(view, options);
}

void Simulation::enqueue_draw(const View& view, const DrawOptions& options) {
  require_method(options.method);
  rasterizer_.enqueue(view, options);
}

void Simulation::launch_peak_rate(PeakRate rate) {
  require_scene("launch_peak_rate");
  search_.moved(false);
  probe_.launch_peak_rate(rate);
}

void Simulation::check_peak_rate(PeakRate rate) {
  require_scene("check_peak_rate");
  search_.moved(false);
  probe_.check_peak_rate(rate);
}

void Simulation::prepare_to_share() {
  require_scene("draw");
  search_.prepare_counts(false);
}

}  // namespace spherepair
