// SPDX-License-Identifier: MIT
#include "bench/viewer/viewer.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstring>
#include <utility>

#include "bench/check/finite_state.h"
#include "bench/measure/choice.h"
#include "common/scene/counted.h"

namespace spherepair {

void Viewer::Choice::pick(const std::string& name) {
  const auto found = std::ranges::find(names, name);
  chosen = found == names.end() ? 0 : size_t(found - names.begin());
}

// Exponential moving average over about ten timed frames, so that the number is readable. Frames that are not timed
// need not wait after each stage.
template <typename Work>
void Viewer::timed(double& seconds, Work work) {
  if (frames_ % 16 != 0 && seconds != 0) return work();
  const auto start = std::chrono::steady_clock::now();
  work();
  backend().finish();
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  seconds += (seconds == 0 ? 1 : 0.1) * (taken.count() - seconds);
}

Viewer::Viewer(const Session& session, const Start& start, const Options& options)
    : session_(session),
      start_(start),
      options_(options),
      bounds_(bounds_of(start.scene.positions)),
      orbit_(bounds_),
      speed_(options.speed) {
  bounds_.low[1] = std::min(bounds_.low[1], double(start.scene.plane));
  orbit_ = Orbit(bounds_);
  for (const auto& each : session.backends()) backends_.names.push_back(each->info().name);
  backends_.pick(options.backend);
  running_ = backends_.chosen;
  restart();
  list_choices();
  methods_.pick(options.method);
}

void Viewer::restart() {
  upload_start(start_, backend());
  step_ = start_.step;
  search_.reset();
  hold();
}

void Viewer::hold() {
  last_.reset();
  owed_ = 0;
}

void Viewer::scale_speed(double factor) {
  if (speed_ > 0) speed_ = std::clamp(speed_ * factor, slowest, fastest);
  hold();
}

// The steps of a frame that begins at `now`, seconds. Steps that the frame has no time for are dropped: a run that
// cannot keep up falls behind the clock.
uint64_t Viewer::due(double now) {
  if (speed_ == 0) return 1;
  if (last_) owed_ = owed_ - std::floor(owed_) + (now - *last_) * speed_ / double(start_.scene.dt);
  last_ = now;
  return uint64_t(std::min(owed_, 0x1p53));
}

void Viewer::list_choices() {
  const std::string method = methods_.names.empty() ? "" : methods_.name();
  const std::string draw = draws_.names.empty() ? "" : draws_.name();
  methods_.names.clear();
  draws_.names.clear();
  for (const Method each : backend().methods())
    if (!start_.scene.contact.periodic || each != Method::collide_group) methods_.names.push_back(method_name(each));
  for (const DrawMethod each : drawing().draw_methods()) draws_.names.push_back(draw_method_name(each));
  methods_.pick(method);
  draws_.pick(draw);
}

// Continues the run on another backend with the same bits; if that fails, stays on this one.
void Viewer::change_backend(size_t next) {
  Scene scene = start_.scene;
  const Motion::State state = current_state(backend());
  require_finite(state, step_);
  const MotionState saved = backend().save();
  scene.positions = state.positions;
  scene.velocities = state.velocities;
  const size_t before = running_;
  try {
    running_ = next;
    backend().resume(scene, saved);
    error_.clear();
  } catch (const BackendError& error) {
    error_ = error.what();
    running_ = backends_.chosen = before;
  }
  seconds_ = {};
  search_.reset();
  hold();
  list_choices();
}

// Chooses colours from the current spheres. The limits then stay, so that colours can be compared from step to step.
void Viewer::choose_colours() {
  coloured_by_ = colours_.chosen;
  palette_ = contact_look();
  if (coloured_by_ == COLOUR_BY_CONTACTS) return;
  const Motion::State state = current_state(backend());
  const bool speed = coloured_by_ == COLOUR_BY_SPEED;
  double lowest = speed ? 0 : INFINITY, highest = 0;
  for (size_t i = 0; i < start_.scene.size(); ++i) {
    const vec4& v = state.velocities[i];
    const double value = speed ? std::hypot(double(v.x), double(v.y), double(v.z)) : double(state.positions[i].w);
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
  palette_ = range_look(uint(coloured_by_), std::min(lowest, highest), highest);
}

// Takes the frame's steps, but stops after their share of a frame. To measure it, waits for the device.
void Viewer::move_steps(const Window& window, uint64_t steps) {
  constexpr double share = 1.0 / 30;  // seconds
  const double begin = window.seconds();
  const auto late = [&](uint64_t done) {
    if (std::has_single_bit(done)) backend().finish();
    return window.seconds() - begin > share;
  };
  uint64_t done = 0;
  do {
    timed(seconds_.move, [&] {
      backend().move();
      if (done + 1 == steps) backend().evaluate_positions();
    });
    ++step_;
  } while (++done < steps && !late(done));
}

void Viewer::advance(const Window& window) {
  if (paused_) hold();
  const uint64_t steps = std::exchange(single_step_, false) ? 1 : paused_ ? 0 : due(window.seconds());
  if (steps == 0) return;
  search_.reset();
  move_steps(window, steps);
}

void Viewer::collide() {
  CollideOptions options = {.method = method_from_name(methods_.name())};
  const bool lit =
      light_ && options.method == Method::collide_grid && draws_.name() == "compute" && start_.scene.size() > 1;
  if (lit) options.grid.cells = Cells::dense;
  const Search wanted{options.method, lit};
  if (search_ == wanted) return;
  timed(seconds_.collide, [&] { backend().collide(options); });
  totals_ = backend().collisions();
  search_ = wanted;
}

// Shows the image without the host, if it can stay on the GPU; else returns false, and the image is uploaded.
bool Viewer::shown_without_host(uint texture) {
  if (!options_.shared) return false;
  try {
    return drawing().show(texture);
  } catch (const BackendError& error) {
    error_ = error.what();
    return false;
  }
}

bool Viewer::Shown::operator==(const Shown& other) const {
  return std::memcmp(&view, &other.view, sizeof view) == 0 && step == other.step && backend == other.backend &&
         draw == other.draw;
}

// The image as `render --no-box` draws it.
ImageOptions Viewer::still_image(const Window& window) const {
  const auto [width, height] = window.size();
  ImageOptions image{orbit_.camera(double(width) / height), palette_, width, height, still_samples,
                     draw_method_from_name(draws_.name())};
  image.look.light = {-0.3, 0.9, -0.3};  // from above even if the camera looks down
  image.look.ground = double(start_.scene.plane);
  if (search_->lit) image.look.lighting = LIGHT_OCCLUSION | LIGHT_SHADOW | LIGHT_GROUND;
  return image;
}

// Takes and reads back one sample a frame of an image that stands still, and shows their mean after the last one.
void Viewer::refine(Window& window, const ImageOptions& image) {
  if (samples_.count() == still_samples) return;
  samples_.add(draw_sample(drawing(), image, samples_.count()).pixels);
  if (samples_.count() < still_samples) return;
  window.texture(image.width, image.height);
  window.upload(samples_.mean());
}

void Viewer::draw(Window& window) {
  const ImageOptions image = still_image(window);
  const Shown now{make_view(image.camera, image.look, image.width, image.height), step_, running_, draws_.chosen};
  if (shown_ == now) {
    if (paused_) refine(window, image);
    return;
  }
  shown_ = now;
  samples_ = {};
  timed(seconds_.draw, [&] { drawing().draw(now.view, {.method = image.method}); });
  timed(seconds_.show, [&] {
    const uint texture = window.texture(image.width, image.height);
    if (!shown_without_host(texture)) window.upload(drawing().image());
  });
}

bool Viewer::frame(Window& window, char key) {
  if (!take_keys(window, key)) return false;
  if (backends_.chosen != running_) change_backend(backends_.chosen);
  advance(window);
  collide();
  if (colours_.chosen != coloured_by_) choose_colours();
  draw(window);
  if (std::exchange(saving_, false)) save_image(window);
  if (panel_) show_panel(window);
  window.show();
  if (frames_++ == 0) first_frame_ = std::chrono::steady_clock::now();
  return true;
}

std::string Viewer::summary() const {
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - first_frame_;
  const std::string rate =
      frames_ < 2 ? "" : fmt::format("{} frames a second; ", format_number(double(frames_ - 1) / taken.count()));
  const std::string times =
      fmt::format("{}move {} ms, collide {} ms, draw {} ms, to the window {} ms\n", rate, format_ms(seconds_.move),
                  format_ms(seconds_.collide), format_ms(seconds_.draw), format_ms(seconds_.show));
  return times + fmt::format("{} {}, drawn by {}: step {}, {}, fingerprint {}", backends_.name(), methods_.name(),
                             draws_.name(), step_, counted(totals_.pairs, "pair"),
                             hex64(totals_.fingerprint.a) + hex64(totals_.fingerprint.b));
}

}  // namespace spherepair
