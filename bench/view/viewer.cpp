// SPDX-License-Identifier: MIT
#include "bench/view/viewer.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "bench/check/finite_state.h"
#include "bench/image/legend.h"
#include "bench/measure/choice.h"

namespace spherepair {

void Viewer::Choice::pick(const std::string& name) {
  const auto found = std::ranges::find(names, name);
  chosen = found == names.end() ? 0 : size_t(found - names.begin());
}

// Exponential moving average over about ten timed frames, so that the number is readable. The others need not wait
// after each stage.
template <typename Work>
void Viewer::timed(double& seconds, Work work) {
  if (frames_ % 16 != 0 && seconds != 0) return work();
  const auto start = std::chrono::steady_clock::now();
  work();
  backend().finish();
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  seconds += (seconds == 0 ? 1 : 0.1) * (taken.count() - seconds);
}

Viewer::Viewer(const Session& session, const Start& start, const std::string& backend, const std::string& method,
               bool shared)
    : session_(session), start_(start), shared_(shared), bounds_(bounds_of(start.scene.positions)), history_(start) {
  bounds_.low[1] = std::min(bounds_.low[1], double(start.scene.plane));
  for (const auto& each : session.backends()) backends_.names.push_back(each->info().name);
  backends_.pick(backend);
  running_ = backends_.chosen;
  go_to(start.step);
  list_choices();
  methods_.pick(method);
}

void Viewer::go_to(uint64_t step) {
  history_.go_to(backend(), step);
  step_ = step;
  search_.reset();
}

// Of the exact spheres, by whichever method the image is drawn.
void Viewer::pick(std::array<uint, 2> pixel) {
  picked_.clear();
  if (pixel[0] >= view_.width || pixel[1] >= view_.height) return;
  backend().draw(view_, {.keep_visible = true});
  const uint sphere = backend().visible()[size_t(pixel[1]) * view_.width + pixel[0]].x;
  if (sphere >= start_.scene.size()) return;
  const Backend::State state = current_state(backend());
  const vec4 &at = state.positions[sphere], &v = state.velocities[sphere];
  picked_ = fmt::format("sphere {} at step {}: {} contacts\ncentre {:.4g}, {:.4g}, {:.4g}; radius {:.4g}; speed {:.4g}",
                        sphere, step_, backend().counts()[sphere], at.x, at.y, at.z, at.w,
                        std::hypot(double(v.x), double(v.y), double(v.z)));
}

void Viewer::list_choices() {
  const std::string method = methods_.names.empty() ? "" : methods_.name();
  const std::string draw = draws_.names.empty() ? "" : draws_.name();
  methods_.names.clear();
  draws_.names.clear();
  for (const Method each : backend().methods()) methods_.names.push_back(method_name(each));
  for (const DrawMethod each : backend().draw_methods()) draws_.names.push_back(draw_method_name(each));
  methods_.pick(method);
  draws_.pick(draw);
}

// Continues the run on another backend with the same bits; if that fails, stays on this one.
void Viewer::change_backend(size_t next) {
  Scene scene = start_.scene;
  const Backend::State state = current_state(backend());
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
  list_choices();
}

void Viewer::take_keys(Window& window, char key) {
  const auto pressed = [&](char wanted) { return key == wanted || window.pressed(wanted); };
  if (pressed(' ')) paused_ = !paused_;
  if (pressed('n')) single_step_ = paused_ = true;
  if (pressed('l')) light_ = !light_;
  if (pressed('h')) panel_ = !panel_;
  if (pressed('b')) backends_.next();
  if (pressed('m')) methods_.next();
  if (pressed('d')) draws_.next();
  if (pressed('c')) colours_.next();
  if (pressed('r')) go_to(start_.step);
  if (pressed('z') && step_ > start_.step) paused_ = true, go_to(step_ - 1);
}

void Viewer::fill_panel(Window& window) {
  window.begin_panel();
  window.choose("backend (b)", backends_.names, backends_.chosen);
  window.choose("method (m)", methods_.names, methods_.chosen);
  window.choose("drawing (d)", draws_.names, draws_.chosen);
  window.choose("colours (c)", colours_.names, colours_.chosen);
  window.text(std::array{"contacts:", "speed in m/s, at least:", "radius in m, at least:"}[coloured_by_]);
  window.legend(palette_.palette, legend_labels(palette_));
  window.check("paused (space)", paused_);
  if (window.button("one step (n)")) single_step_ = paused_ = true;
  if (window.button("restart (r)")) go_to(start_.step);
  uint64_t wanted = step_;
  window.slide("step (z: back)", wanted, history_.first(), history_.last());
  if (wanted != step_) paused_ = true, go_to(wanted);
  window.check("light and shadows (l)", light_);
  window.text(fmt::format("{}, {} spheres", start_.label, start_.scene.size()));
  window.text(device_label(backend().info()));
  window.text(fmt::format("step {}: {} pairs, {} spheres in contact", step_, totals_.pairs, totals_.colliding_spheres));
  window.text(fmt::format("move {} ms, collide {} ms", format_ms(seconds_.move), format_ms(seconds_.collide)));
  if (draws_.name() != draw_method_name(DrawMethod::compute) && backend().transfer_taken())
    window.text(fmt::format("spheres to OpenGL: {}", transfer_name(*backend().transfer_taken())));
  window.text(fmt::format("draw {} ms, to the window {} ms", format_ms(seconds_.draw), format_ms(seconds_.show)));
  window.text("drag to rotate, scroll to zoom, click a sphere, h hides this");
  if (!picked_.empty()) window.text(picked_);
  if (!error_.empty()) window.text(wrap(error_, 50, ""));
  window.end_panel();
}

void Viewer::turn_camera(const Window& window) {
  const auto [right, down] = window.dragged();
  orbit_.azimuth -= 0.4 * right;
  orbit_.elevation = std::clamp(orbit_.elevation + 0.4 * down, -5.0, 85.0);
  orbit_.distance = std::clamp(orbit_.distance * std::pow(0.9, window.scrolled()), 0.05, 5.0);
}

// Of the spheres as they stand: the limits then stay as they are, so that colours can be compared from step to step.
void Viewer::choose_colours() {
  coloured_by_ = colours_.chosen;
  palette_ = contact_look();
  if (coloured_by_ == COLOUR_BY_CONTACTS) return;
  const Backend::State state = current_state(backend());
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

void Viewer::advance() {
  if (paused_ && !single_step_) return;
  single_step_ = false;
  search_.reset();
  timed(seconds_.move, [&] { backend().move(), backend().evaluate_positions(); });
  history_.record(backend(), ++step_);
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

// Whether the image could go to the window on the GPU; where it cannot, it is uploaded.
bool Viewer::shown_without_host(uint texture) {
  if (!shared_) return false;
  try {
    return backend().show(texture);
  } catch (const BackendError& error) {
    error_ = error.what();
    return false;
  }
}

void Viewer::draw(Window& window) {
  const auto [width, height] = window.size();
  Camera camera = spherepair::frame(bounds_, orbit_.azimuth, orbit_.elevation, 30, double(width) / height);
  for (int a = 0; a < 3; ++a) camera.eye[a] = camera.target[a] + orbit_.distance * (camera.eye[a] - camera.target[a]);
  Look look = palette_;
  look.light = {-0.3, 0.9, -0.3};  // from above even if the camera looks down
  if (search_->lit) look.lighting = LIGHT_OCCLUSION | LIGHT_SHADOW | LIGHT_GROUND;
  look.ground = double(start_.scene.plane);
  view_ = make_view(camera, look, width, height);
  timed(seconds_.draw, [&] { backend().draw(view_, {.method = draw_method_from_name(draws_.name())}); });
  timed(seconds_.show, [&] {
    const uint texture = window.texture(view_.width, view_.height);
    if (!shown_without_host(texture)) window.upload(backend().image());
  });
}

// Choices in the panel take effect in the next frame.
void Viewer::frame(Window& window, char key) {
  take_keys(window, key);
  turn_camera(window);
  if (backends_.chosen != running_) change_backend(backends_.chosen);
  advance();
  collide();
  if (colours_.chosen != coloured_by_) choose_colours();
  draw(window);
  if (const auto pixel = window.clicked()) pick(*pixel);
  if (panel_) fill_panel(window);
  window.show();
  if (frames_++ == 0) first_frame_ = std::chrono::steady_clock::now();
}

std::string Viewer::summary() const {
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - first_frame_;
  const std::string rate =
      frames_ < 2 ? "" : fmt::format("{} frames a second; ", format_number(double(frames_ - 1) / taken.count()));
  const std::string times =
      fmt::format("{}move {} ms, collide {} ms, draw {} ms, to the window {} ms\n", rate, format_ms(seconds_.move),
                  format_ms(seconds_.collide), format_ms(seconds_.draw), format_ms(seconds_.show));
  return times + fmt::format("{} {}, drawn by {}: step {}, {} pairs, fingerprint {}", backends_.name(), methods_.name(),
                             draws_.name(), step_, totals_.pairs,
                             hex64(totals_.fingerprint.a) + hex64(totals_.fingerprint.b));
}

}  // namespace spherepair
