// SPDX-License-Identifier: MIT
// The viewer's keys and panel, and the actions that only they start.
#include <fmt/format.h>

#include <cmath>

#include "bench/check/finite_state.h"
#include "bench/formats/png_file.h"
#include "bench/legend/legend.h"
#include "bench/measure/choice.h"
#include "bench/viewer/viewer.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

namespace fs = std::filesystem;

// A name that no file has.
fs::path free_name(const fs::path& folder, uint64_t step) {
  for (uint64_t k = 1;; ++k) {
    const fs::path path = folder / fmt::format("spherepair-{}{}.png", step, k == 1 ? "" : fmt::format("-{}", k));
    std::error_code unreadable;  // reported when a file is written to it
    if (!fs::exists(fs::symlink_status(path, unreadable))) return path;
  }
}

}  // namespace

// Picks from the exact spheres, whatever method drew the image.
void Viewer::pick(std::array<uint, 2> pixel) {
  picked_.clear();
  const View& seen = shown_->view;
  if (pixel[0] >= seen.width || pixel[1] >= seen.height) return;
  drawing().draw(seen, {.keep_visible = true});
  const uint sphere = drawing().visible()[size_t(pixel[1]) * seen.width + pixel[0]].x;
  if (sphere >= start_.scene.size()) return;
  const Motion::State state = current_state(backend());
  const vec4 &at = state.positions[sphere], &v = state.velocities[sphere];
  picked_ = fmt::format("sphere {} at step {}: {}\ncentre {:.4g}, {:.4g}, {:.4g}; radius {:.4g}; speed {:.4g}", sphere,
                        step_, counted(backend().counts()[sphere], "contact"), at.x, at.y, at.z, at.w,
                        std::hypot(double(v.x), double(v.y), double(v.z)));
}

void Viewer::save_image(const Window& window) {
  const ImageOptions image = still_image(window);
  std::vector<uint> pixels = draw_image(drawing(), image).pixels;
  const Legend legend = legend_of(image.look, {counted(start_.scene.size(), "sphere"), counted(totals_.pairs, "pair"),
                                               fmt::format("step {}", step_)});
  const auto strip = LegendStrip::within(legend, image.width, image.height);
  if (strip) strip->append_to(pixels, legend);
  try {
    const fs::path path = free_name(options_.folder, step_);
    write_png(path, pixels, image.width, image.height + (strip ? strip->height() : 0));
    saved_ = "saved " + path.string();
  } catch (const std::exception& error) {
    saved_ = error.what();
  }
}

// False for the key that closes the window.
bool Viewer::take_keys(Window& window, char key) {
  const auto pressed = [&](char wanted) { return key == wanted || window.pressed(wanted); };
  if (pressed(' ')) paused_ = !paused_;
  if (pressed('n')) single_step_ = paused_ = true;
  if (pressed('+')) pace_.scale(2);
  if (pressed('-')) pace_.scale(0.5);
  if (pressed('f')) pace_.toggle_clock();
  if (pressed('l')) light_ = !light_;
  if (pressed('e')) box_ = !box_;
  if (pressed('h')) panel_ = !panel_;
  if (pressed('p')) folded_ = !folded_, panel_ = true;
  if (pressed('b')) backends_.next();
  if (pressed('m')) methods_.next();
  if (pressed('d')) draws_.next();
  if (pressed('c')) colours_.next();
  if (pressed('a')) orbit_.reset();
  if (pressed('s')) saving_ = true;
  if (pressed('r')) go_to(start_.step);
  if (pressed('z') && step_ > start_.step) paused_ = true, go_to(step_ - 1);
  orbit_.turn(window.dragged());
  if (shown_) orbit_.pan(window.panned(), shown_->view);
  orbit_.zoom(window.scrolled());
  return !pressed('q') && !pressed(escape_key);
}

void Viewer::show_panel(Window& window) {
  window.begin_panel(fmt::format("spherepair, step {}", step_), folded_);
  if (!folded_) fill_panel(window);
  window.end_panel();
}

void Viewer::fill_panel(Window& window) {
  window.choose("backend (b)", backends_.names, backends_.chosen);
  window.choose("method (m)", methods_.names, methods_.chosen);
  window.choose("drawing (d)", draws_.names, draws_.chosen);
  window.choose("colours (c)", colours_.names, colours_.chosen);
  window.text(std::array{"contacts:", "speed in m/s, at least:", "radius in m, at least:"}[coloured_by_]);
  window.legend(palette_.palette, legend_labels(palette_));
  uint64_t wanted = step_;
  window.slide("step (z: back)", wanted, history_.first(), history_.last());
  if (wanted != step_) paused_ = true, go_to(wanted);
  if (window.button("one step (n)")) single_step_ = paused_ = true;
  window.same_row();
  if (window.button("restart (r)")) go_to(start_.step);
  window.same_row();
  if (window.button("save PNG (s)")) saving_ = true;
  window.check("paused (space)", paused_);
  window.same_row();
  window.check("lit (l)", light_);
  window.same_row();
  window.check("box (e)", box_);
  tell_times(window);
  window.text("drag: rotate, shift-drag: pan, scroll: zoom");
  window.text("a: all in view, p: fold, h: hide, q: close");
  for (const std::string& line : {picked_, saved_, error_})
    if (!line.empty()) window.text(line);
}

void Viewer::tell_times(Window& window) {
  window.text(fmt::format("{}, {}", start_.label, counted(start_.scene.size(), "sphere")));
  window.text(device_label(backend().info()));
  window.text(fmt::format("step {}: {}, {} in contact", step_, counted(totals_.pairs, "pair"),
                          counted(totals_.colliding_spheres, "sphere")));
  window.text(pace_.text() + "  (+, -, f)");
  window.text(fmt::format("move {} ms, collide {} ms", format_ms(seconds_.move), format_ms(seconds_.collide)));
  if (draws_.name() != draw_method_name(DrawMethod::compute) && drawing().transfer_taken())
    window.text(fmt::format("spheres to OpenGL: {}", transfer_name(*drawing().transfer_taken())));
  window.text(fmt::format("draw {} ms, to the window {} ms", format_ms(seconds_.draw), format_ms(seconds_.show)));
}

}  // namespace spherepair
