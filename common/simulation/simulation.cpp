// SPDX-License-Identifier: MIT
#include "common/simulation/simulation.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/backend/checks.h"

namespace spherepair {

Simulation::Simulation(std::unique_ptr<Device> device, PipelineOpener open)
    : device_(std::move(device)),
      context_(*device_, std::move(open)),
      motion_(context_),
      sorter_(context_),
      search_(context_, sorter_),
      contacts_(context_, motion_),
      swept_(context_, motion_),
      rasterizer_(context_, motion_, sorter_, search_),
      probe_(context_) {}

std::vector<Method> Simulation::methods() const {
  std::vector<Method> all = device_methods();
  if (device_->capabilities().tensor_groups) all.push_back(Method::collide_tensor);
  return all;
}

void Simulation::require_scene(const char* what) const {
  if (!context_.buffers.bytes(SLOT_POSITION))
    throw BackendError(fmt::format("{}: {} needs a scene; call upload first", info().name, what));
}

void Simulation::begin(const Scene& scene, const MotionState* saved) {
  check_scene(scene);
  finish();
  context_.params = {};
  context_.set_spheres(scene);
  context_.moved();
  device_->work = {.plans = 1};
  sorter_.upload(scene);
  motion_.upload(scene, saved);
  search_.upload(scene);
  contacts_.upload(scene, saved ? saved->contact_steps : 0);
  swept_.upload();
  rasterizer_.upload();
  probe_.upload();
}

void Simulation::move() {
  require_scene("move");
  bool cleared = !search_.counts_sorted();
  if (contacts_.on()) {
    contacts_.step(cleared);
  } else {
    cleared = motion_.step(cleared);
  }
  if (cleared) search_.cleared();
}

void Simulation::complete_moves() {
  if (contacts_.on() && contacts_.complete()) search_.forget();
}

void Simulation::evaluate_positions() {
  require_scene("evaluate_positions");
  complete_moves();
  evaluate();
}

void Simulation::evaluate() {
  if (motion_.evaluate_positions()) search_.cleared();
}

void Simulation::evaluate_state() {
  require_scene("evaluate_state");
  complete_moves();
  contacts_.require_sound();
  motion_.evaluate_state();
}

Motion::State Simulation::state() {
  require_scene("state");
  complete_moves();
  if (!motion_.state_current())
    throw BackendError(fmt::format("{}: the state is that of an earlier step; call evaluate_state", info().name));
  return motion_.state();
}

MotionState Simulation::save() {
  evaluate_state();
  MotionState saved = motion_.save();
  saved.contact_steps = contacts_.steps();
  return saved;
}

const Memory& Simulation::positions() {
  evaluate_positions();
  finish();
  return context_.buffers.memory(SLOT_POSITION);
}

void Simulation::positions_changed() {
  context_.moved();
  contacts_.forget_list();
}

MethodChoice Simulation::choice(const CollideOptions& options) const {
  require_scene("choice");
  return search_.choice(options);
}

void Simulation::collide(const CollideOptions& options) {
  require_scene("collide");
  complete_moves();
  contacts_.require_sound();
  enqueue_collide(options);
  search_.complete();
}

void Simulation::enqueue_collide(const CollideOptions& options) {
  require_scene("collide");
  complete_moves();
  search_.require_options(options);
  if (contacts_.periodic()) check_images(options);
  if (options.swept) {
    contacts_.forget_list();
    swept_.list_paths(options);
  } else if (contacts_.periodic()) {
    contacts_.list_near_pairs(options);
  }
  evaluate();
  search_.enqueue(options);
}

void Simulation::step(const CollideOptions& options) {
  enqueue_step(options);
  search_.complete();
}

void Simulation::enqueue_step(const CollideOptions& options) {
  require_scene("enqueue_step");
  // Contacts and swept searches list near pairs by a search of their own.
  if (contacts_.on() || options.swept) return Backend::enqueue_step(options);
  search_.require_options(options);
  device_->begin_step(options.api);
  move();
  evaluate();
  search_.enqueue(options, true);
}

void Simulation::run_steps(uint steps) {
  enqueue_steps(steps);
  search_.complete();
}

void Simulation::enqueue_steps(uint steps) {
  require_scene("persistent steps");
  motion_.leave_steps_to_search();
  search_.enqueue_steps(steps);
}

std::vector<DrawMethod> Simulation::draw_methods() const {
  if (has_pipeline()) return {all_draw_methods().begin(), all_draw_methods().end()};
  return {DrawMethod::compute};
}

void Simulation::require_method(const DrawOptions& options) const {
  const DrawMethod method = options.method;
  require_scene("draw");
  if (options.transfer && (method == DrawMethod::compute || transfers().empty()))
    throw std::invalid_argument(
        fmt::format("{}: drawing by {} transfers no spheres to OpenGL", info().name, draw_method_name(method)));
  if (std::ranges::count(draw_methods(), method) == 0)
    throw std::invalid_argument(
        fmt::format("{}: drawing by {} needs OpenGL's pipeline, which this backend or build lacks; draw by compute",
                    info().name, draw_method_name(method)));
}

void Simulation::draw(const View& view, const DrawOptions& options) {
  require_method(options);
  complete_moves();
  rasterizer_.run(view, options);
}

void Simulation::enqueue_draw(const View& view, const DrawOptions& options) {
  require_method(options);
  complete_moves();
  rasterizer_.enqueue(view, options);
}

void Simulation::launch(PeakRate rate) {
  require_scene("a peak rate");
  complete_moves();
  search_.forget();
  probe_.launch_peak_rate(rate);
}

void Simulation::check(PeakRate rate) {
  require_scene("a peak rate");
  search_.forget();
  probe_.check_peak_rate(rate);
}

void Simulation::set_classes(std::span<const uint> classes) {
  require_scene("set_classes");
  rasterizer_.set_classes(classes);
}

bool Simulation::show(uint texture) { return has_pipeline() && rasterizer_.show(texture); }

void Simulation::finish() {
  complete_moves();
  device_->wait();
  if (GraphicsPipeline* pipeline = context_.other_pipeline.opened()) pipeline->finish();
}

Preparations Simulation::preparations() const {
  Preparations all = device_->prepared;
  for (const GraphicsPipeline* pipeline : {device_->pipeline(), context_.other_pipeline.opened()})
    if (pipeline) all = all + pipeline->preparations();
  return all;
}

std::vector<Transfer> Simulation::transfers() const { return context_.other_pipeline.ways(); }

std::optional<Transfer> Simulation::transfer_taken() const {
  const GraphicsPipeline* pipeline = context_.other_pipeline.opened();
  return pipeline && rasterizer_.through_pipeline() ? pipeline->taken() : std::nullopt;
}

void Simulation::transfer(Transfer way) {
  require_scene("transfer");
  complete_moves();
  evaluate();
  search_.prepare_counts(false);
  context_.other_pipeline.get().transfer(context_.sphere_arrays(SLOT_COUNT), way);
}

}  // namespace spherepair
