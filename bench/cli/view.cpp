// SPDX-License-Identifier: MIT
// spherepair view
#include "bench/cli/view.h"

#include <fmt/format.h>

#include "bench/cli/options.h"
#include "bench/formats/png_file.h"
#include "bench/io/arguments.h"
#include "bench/measure/choice.h"
#include "bench/view/viewer.h"

namespace spherepair {

int view_command(const CommandLine& line, const ViewOptions& options) {
  if (!options.backend.empty()) require_known_backends({options.backend});
  OutputFiles files;
  add_inputs(files, options.start);
  files.write("--screenshot", options.screenshot_file);
  const Start start = start_of(options.start, line.open.threads);
  const std::unique_ptr<Window> window = open_window("spherepair: " + start.label, options.width, options.height);
  const Session session({}, line.open);
  fmt::print("{}\n", session.summary());
  std::string first = options.backend;
  if (first.empty()) first = choose_backend("", line.open).backend->info().name;
  Backend* backend = session.find(first);
  if (!backend) throw BackendError(fmt::format("the backend {} could not be opened, see above", first));
  const Method method = choose_method(options.method, *backend);
  Viewer viewer(session, start, first, options.method.empty() ? "collide_grid" : method_name(method));
  for (uint64_t frame = 0; window->next(); ++frame) {
    viewer.frame(*window, frame < options.keys.size() ? options.keys[frame] : '\0');
    if (options.frames && frame + 1 == options.frames) break;
  }
  if (!options.screenshot_file.empty()) {
    const auto [width, height] = window->size();
    write_png(options.screenshot_file, window->screenshot(), width, height);
  }
  fmt::print("{}\n", viewer.summary());
  return kOk;
}

void add_view(CLI::App& app, CommandLine& line, std::function<int()>& action) {
  auto* command = app.add_subcommand("view", "Show moving spheres in a window; backend and method can be changed");
  auto options = std::make_shared<ViewOptions>();
  add_start_options(*command, options->start);
  command->add_option("--backend", options->backend, "Backend at the start; default: a GPU if there is one, else cpu");
  command->add_option("--method", options->method, "Collision method at the start; default: collide_grid");
  add_size_option(*command, options->width, options->height);
  command->add_option("--frames", options->frames, "Close after so many frames")->group("");
  command->add_option("--screenshot", options->screenshot_file, "PNG of the last frame")->group("");
  command->add_option("--keys", options->keys, "Key presses, one per frame")->group("");
  add_open_options(*command, line.open);
  command->footer(
      "Keys: space pauses, n takes one step, b, m and d change backend, method and drawing, l toggles light and "
      "shadows,\n"
      "r restarts. Drag the mouse to rotate, scroll to zoom. Without a display, use render.\n"
      "Example:\n  spherepair view --scene random --n 16384");
  command->callback([=, &line, &action] {
    finish_start_options(*command, options->start);
    action = [=, &line] { return view_command(line, *options); };
  });
}

}  // namespace spherepair
