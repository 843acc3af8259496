// SPDX-License-Identifier: MIT
// spherepair render
#include <fmt/format.h>

#include "answers.h"
#include "arguments.h"
#include "choice.h"
#include "context.h"
#include "files.h"
#include "legend.h"
#include "photo.h"
#include "png_file.h"
#include "replaced_file.h"

namespace spherepair {
namespace {

namespace fs = std::filesystem;

struct Series {
  const CommandLine& line;
  const RenderOptions& options;
  const Start& start;
  const ChosenBackend& chosen;
  Method method;
  Shot shot;
};

// picture.png, or of several picture-007.png.
fs::path name_of(const RenderOptions& options, uint64_t k) {
  fs::path path = options.output_file;
  if (options.pictures == 1) return path;
  const size_t digits = std::to_string(options.pictures - 1).size();
  return path.replace_filename(fmt::format("{}-{:0{}}.png", path.stem().string(), k, digits));
}

void check_options(const RenderOptions& options) {
  if (fs::path(options.output_file).extension() != ".png")
    throw std::invalid_argument(fmt::format("the output {} does not end in .png", options.output_file));
  if (!options.backend.empty()) require_known_backends({options.backend});
  for (const auto& [name, value] : {std::pair{"--eye", options.camera.eye}, {"--target", options.camera.target}})
    if (!value.empty() && value.size() != 3) throw std::invalid_argument(fmt::format("{} needs x,y,z", name));
  draw_method_from_name(options.draw);
  check_writable(name_of(options, 0));
}

json record(const Series& series, uint64_t step, const Collisions& totals) {
  const Shot& shot = series.shot;
  json views = json::array();
  for (uint k = 0; k < shot.samples; ++k)
    views.push_back(to_json(make_view(shot.camera, shot.look, shot.width, shot.height, jitter(k, shot.samples))));
  return {{"context", capture_context(series.line.words)},
          {"backends", series.chosen.session->to_json()},
          {"scene", series.start.record},
          {"step", step},
          {"method", method_name(series.method)},
          {"drawn_by", draw_method_name(shot.method)},
          {"pairs", totals.pairs},
          {"colliding_spheres", totals.colliding_spheres},
          {"fingerprint", hex64(totals.fingerprint.a) + hex64(totals.fingerprint.b)},
          {"width", shot.width},
          {"height", shot.height},
          {"camera", to_json(shot.camera)},
          {"samples", views}};
}

void take_picture(const Series& series, uint64_t k, uint64_t step) {
  Backend& backend = *series.chosen.backend;
  CollideOptions collide = {.method = series.method};
  if (series.shot.look.lighting) collide.grid.cells = Cells::dense;
  backend.collide(collide);
  const Collisions totals = backend.collisions();
  std::vector<uint> image = take(backend, series.shot);
  if (series.options.legend) draw_legend(image, series.shot.width, series.shot.height, series.shot.look);
  fs::path path = name_of(series.options, k);
  write_png(path, image, series.shot.width, series.shot.height);
  write_file(path.replace_extension(".json"), json_text(record(series, step, totals)));
}

void take_series(const Series& series) {
  Progress progress;
  uint64_t step = series.options.steps;
  for (uint64_t k = 0; k < series.options.pictures; ++k) {
    progress.say(fmt::format("picture {} of {}, step {}", k + 1, series.options.pictures, step));
    take_picture(series, k, step);
    if (k + 1 == series.options.pictures) break;
    for (uint64_t i = 0; i < series.options.every; ++i, ++step) series.chosen.backend->move();
  }
}

}  // namespace

int render_command(const CommandLine& line, const RenderOptions& options) {
  check_options(options);
  const Start start = start_of(options.start, line.open.threads);
  const ChosenBackend chosen = choose_backend(options.backend, line.open);
  const bool lights = !options.plain && options.draw == "compute" && start.scene.size() > 1;
  const Method method =
      lights ? Method::collide_grid : choose_method(options.method, *chosen.backend, start.scene.size());
  for (const std::string& warning : chosen.session->warnings()) fmt::print(stderr, "{}\n", warning);
  chosen.backend->upload(start.scene);
  const double aspect = double(options.width) / options.height;
  for (uint64_t step = 0; step < options.steps; ++step) chosen.backend->move();
  const Camera camera = camera_of(options.camera, bounds_of(chosen.backend->state().positions), aspect);
  Look look = contact_look();
  if (lights) look.lighting = LIGHT_OCCLUSION | LIGHT_SHADOW | LIGHT_GROUND;
  const Shot shot{camera, look, options.width, options.height, options.samples, draw_method_from_name(options.draw)};
  take_series({line, options, start, chosen, method, shot});
  fmt::print("{}{} on {}: scene {}, {} spheres\n", start.notes, chosen.backend->info().name,
             device_label(chosen.backend->info()), start.label, start.scene.size());
  if (options.pictures == 1) {
    fmt::print("{}\n", options.output_file);
  } else {
    fmt::print("{} to {}\n", name_of(options, 0).string(), name_of(options, options.pictures - 1).string());
  }
  return kOk;
}

}  // namespace spherepair
