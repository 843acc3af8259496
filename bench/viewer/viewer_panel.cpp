// SPDX-License-Identifier: MIT
// The viewer's keys and panel, and the actions that only they start.
#include <fmt/format.h>

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
  if (pressed('+')) scale_speed(2);
  if (pressed('-')) scale_speed(0.5);
  if (pressed('l')) light_ = !light_;
  if (pressed('h')) panel_ = !panel_;
  if (pressed('b')) backends_.next();
  if (pressed('m')) methods_.next();
  if (pressed('d')) draws_.next();
  if (pressed('c')) colours_.next();
  if (pressed('a')) orbit_.reset();
  if (pressed('s')) saving_ = true;
  if (pressed('r')) restart();
  orbit_.turn(window.dragged());
  if (shown_) orbit_.pan(window.panned(), shown_->view);
  orbit_.zoom(window.scrolled());
  return !pressed('q') && !pressed(escape_key);
}

void Viewer::show_panel(Window& window) {
  window.begin_panel(fmt::format("spherepair, step {}", step_));
  window.text(fmt::format("{}, {}", start_.label, counted(start_.scene.size(), "sphere")));
  window.text(fmt::format("{} (b): {}", backends_.name(), device_label(backend().info())));
  window.text(fmt::format("{} (m), drawn by {} (d)", methods_.name(), draws_.name()));
  window.text(
      fmt::format("{}, {} in contact", counted(totals_.pairs, "pair"), counted(totals_.colliding_spheres, "sphere")));
  window.text(std::array{"contacts (c):", "speed in m/s, at least (c):", "radius in m, at least (c):"}[coloured_by_]);
  window.legend(palette_.palette, legend_labels(palette_));
  window.text(speed_ > 0 ? fmt::format("speed {:.3g} (+, -)", speed_) : "one step a frame");
  window.text(fmt::format("move {} ms, collide {} ms", format_ms(seconds_.move), format_ms(seconds_.collide)));
  if (draws_.name() != draw_method_name(DrawMethod::compute) && drawing().transfer_taken())
    window.text(fmt::format("spheres to OpenGL: {}", transfer_name(*drawing().transfer_taken())));
  window.text(fmt::format("draw {} ms, to the window {} ms", format_ms(seconds_.draw), format_ms(seconds_.show)));
  window.text("space: pause, n: one step, r: restart, l: light");
  window.text("drag: rotate, shift-drag: pan, scroll: zoom, a: all");
  window.text("s: save PNG, h: hide this, q: close");
  for (const std::string& line : {saved_, error_})
    if (!line.empty()) window.text(line);
  window.end_panel();
}

}  // namespace spherepair
