// SPDX-License-Identifier: MIT
// spherepair view
#include <fmt/format.h>

#include "bench/cli/commands.h"
#include "bench/formats/png_file.h"
#include "bench/io/arguments.h"
#include "bench/measure/choice.h"
#include "bench/options/options.h"
#include "bench/viewer/viewer.h"
#include "common/backend/checks.h"

namespace spherepair {
namespace {

struct Display {
  std::unique_ptr<Window> window;
  bool shared;  // its OpenGL context is for all that draws
};

// Shares the window's context if OpenGL's backend would run on the same renderer. It does not if the user names a GPU,
// or if the window lacks the GPU's driver (VNC): the backends would then run in software.
Display open_display(const std::string& title, const ViewOptions& options, const OpenOptions& open) {
  const auto window = [&](bool shared) { return open_window(title, options.width, options.height, shared); };
  if (!open.gl_device.empty() || !open.cuda_device.empty() || !open.vulkan_device.empty())
    return {window(false), false};
  std::string renderer;
  try {
    renderer = open_backend("opengl", open)->info().device;
    std::unique_ptr<Window> shared = window(true);
    if (shared->renderer() == renderer) return {std::move(shared), true};
  } catch (const BackendError&) {  // no OpenGL 4.5 or no display: the next attempt reports it
  }
  return {window(false), false};
}

// The backend of a GPU if there is one, else the CPU.
std::string preferred_backend(const Session& session, const OpenOptions& open) {
  if (!open.allow_gpu) return "cpu";
  for (const char* name : {"cuda", "opengl", "vulkan"})
    if (const Backend* backend = session.find(name); backend && on_hardware(*backend)) return name;
  return "cpu";
}

}  // namespace

int view_command(const CommandLine& line, const ViewOptions& options) {
  OutputFiles files;
  add_inputs(files, options.start);
  files.write("--screenshot", options.screenshot_file);
  const Start start = start_of(options.start, line.open.threads);
  if (start.scene.size() == 0)
    throw std::invalid_argument(
        fmt::format("{} has no spheres, so the window would be blank: give --n, or a file with spheres", start.label));
  const Display display = open_display("spherepair: " + start.label, options, line.open);
  const auto& window = display.window;
  OpenOptions open = line.open;
  if (display.shared) open.window = &window->context();
  const Session session({}, open);
  fmt::print(
      "{}{}{}\n", session.summary(),
      display.shared ? "  images stay in the window's OpenGL context\n" : "  images are uploaded to the window\n",
      start.notes + plane_text(start.scene) + describe_contacts(start.scene));
  std::string first = options.backend;
  if (first.empty()) first = preferred_backend(session, open);
  Backend* backend = session.find(first);
  if (!backend) throw BackendError(fmt::format("the backend {} could not be opened, see above", first));
  const Method method = choose_method(options.method, *backend);
  if (start.scene.contact.periodic) check_images({.method = method});
  const std::string first_method = options.method.empty() ? "collide_grid" : method_name(method);
  Viewer viewer(session, start,
                {.backend = first,
                 .method = first_method,
                 .shared = display.shared,
                 .speed = options.speed.value_or(options.frames ? 0 : 1),
                 .folder = std::filesystem::path(options.screenshot_file).parent_path()});
  const auto pace = [&] { return viewer.hurries() ? Present::at_refresh : Present::and_wait; };
  for (uint64_t frame = 0; window->next(pace()); ++frame) {
    if (!viewer.frame(*window, frame < options.keys.size() ? options.keys[frame] : '\0')) break;
    if (options.frames && frame + 1 == options.frames) break;
  }
  if (!options.screenshot_file.empty()) {
    const auto [width, height] = window->size();
    write_png(options.screenshot_file, window->screenshot(), width, height);
  }
  fmt::print("{}\n", viewer.summary());
  return kOk;
}

void add_view(CLI::App& app, CommandLine& line, Action& action) {
  auto* command = app.add_subcommand("view", "Show moving spheres in a window; backend and method can be changed");
  auto options = std::make_shared<ViewOptions>();
  add_start_options(*command, options->start);
  add_backend_option(*command, options->backend, "Backend at the start");
  command->add_option("--method", options->method, "Collision method at the start; default: collide_grid");
  add_size_option(*command, options->width, options->height);
  command
      ->add_option("--speed", options->speed,
                   "Seconds of the scene in a second (default 1); 0 or max: one step a frame, as fast as it goes")
      ->transform(CLI::Transformer(std::map<std::string, std::string>{{"max", "0"}}, CLI::ignore_case).description(""))
      ->check(real_number(0, Viewer::fastest));
  command->add_option("--frames", options->frames, "Close after so many frames")->group("");
  command->add_option("--screenshot", options->screenshot_file, "PNG of the last frame")->group("");
  command->add_option("--keys", options->keys, "Key presses, one per frame")->group("");
  add_open_options(*command, line.open);
  command->footer(
      "Keys:\n"
      "  space  pause, or go on             b  next backend\n"
      "  n      one step                    m  next collision method\n"
      "  r      restart                     d  next drawing method\n"
      "  + -    double or halve the speed   c  next colours: contacts, speed, radius\n"
      "  a      all spheres in view         l  light and shadows\n"
      "  s      save spherepair-STEP.png    h  hide the panel\n"
      "  q Esc  close\n"
      "Mouse: drag to rotate; with shift, or by the right or middle button, to pan; scroll to zoom.\n"
      "An image that stands still is antialiased. Without a display, use render.\n"
      "Example:\n  spherepair view --scene random --n 16384");
  command->callback([=, &line, &action] { action = [=, &line] { return view_command(line, *options); }; });
}

}  // namespace spherepair
