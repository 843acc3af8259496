// SPDX-License-Identifier: MIT
// spherepair render
#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <future>
#include <optional>
#include <thread>

#include "bench/check/finite_state.h"
#include "bench/check/step_result.h"
#include "bench/cli/commands.h"
#include "bench/formats/files.h"
#include "bench/formats/png_file.h"
#include "bench/formats/video.h"
#include "bench/io/arguments.h"
#include "bench/io/context.h"
#include "bench/io/file_bytes.h"
#include "bench/io/output_files.h"
#include "bench/measure/choice.h"
#include "bench/view/antialiased_image.h"
#include "bench/view/legend.h"

namespace spherepair {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFormat = "spherepair render 1";

struct Series {
  const CommandLine& line;
  const RenderOptions& options;
  const Start& start;
  const ChosenBackend& chosen;
  Method method;
  ImageOptions image;
};

// image.png, or image-007.png of several.
fs::path name_of(const RenderOptions& options, uint64_t k) {
  fs::path path = options.output_file;
  if (options.images == 1) return path;
  const size_t digits = std::to_string(options.images - 1).size();
  return path.replace_filename(fmt::format("{}-{:0{}}.png", path.stem().string(), k, digits));
}

fs::path record_of(fs::path image) { return image.replace_extension(".json"); }

void check_extension(const std::string& file, const std::string& extension) {
  if (!file.empty() && fs::path(file).extension() != extension)
    throw std::invalid_argument(fmt::format("the output {} does not end in {}", file, extension));
}

// Records of earlier versions have no format.
bool is_record(const fs::path& path) {
  const json found = json::parse(FileBytes(path).bytes(), nullptr, false);
  if (!found.is_object()) return false;
  if (found.contains("format")) return found["format"] == kFormat;
  return found.contains("context") && found.contains("camera") && found.contains("samples");
}

// The user named the image but not its record, so the record must not replace another file.
void add_image(OutputFiles& files, const std::string& option, const fs::path& image) {
  const fs::path path = record_of(image);
  files.write(option, image);
  files.write("the record of " + option, path);
  if (fs::is_regular_file(path) && !is_record(path))
    throw std::invalid_argument(
        fmt::format("{}, where the record of {} goes, was not written by render: choose another {}", path.string(),
                    option, option));
}

void check_files(const RenderOptions& options) {
  check_extension(options.output_file, ".png");
  check_extension(options.video_file, ".mp4");
  OutputFiles files;
  add_inputs(files, options.start);
  for (uint64_t k = 0; !options.output_file.empty() && k < options.images; ++k)
    add_image(files, "--output", name_of(options, k));
  if (!options.video_file.empty()) add_image(files, "--video", options.video_file);
}

void check_options(const RenderOptions& options) {
  if (options.output_file.empty() && options.video_file.empty())
    throw std::invalid_argument("nothing to write: give --output image.png or --video video.mp4");
  check_files(options);
  if (!options.backend.empty()) require_known_backends({options.backend});
  for (const auto& [name, value] : {std::pair{"--eye", options.camera.eye}, {"--target", options.camera.target}})
    if (!value.empty() && value.size() != 3) throw std::invalid_argument(fmt::format("{} needs x,y,z", name));
  draw_method_from_name(options.draw);
}

// How the spheres came to OpenGL; null where they did not have to.
json transfer_taken(const Backend& backend) {
  const auto taken = backend.transfer_taken();
  return taken ? json(transfer_name(*taken)) : json();
}

json record(const Series& series, uint64_t step, const Collisions& totals) {
  const ImageOptions& image = series.image;
  json views = json::array();
  for (uint k = 0; k < image.samples; ++k)
    views.push_back(to_json(make_view(image.camera, image.look, image.width, image.height, jitter(k, image.samples))));
  const MethodChoice choice = series.chosen.backend->choice({.method = series.method});
  return {{"format", kFormat},
          {"context", capture_context(series.line.words)},
          {"backends", series.chosen.session->to_json()},
          {"scene", series.start.record},
          {"motion", motion_label(series.start.scene.motion)},
          {"dt", series.start.scene.dt},
          {"restitution", series.start.scene.restitution},
          {"step", step},
          {"method", method_name(choice.method)},
          {"choice", to_json(choice)},
          {"drawn_by", draw_method_name(image.method)},
          {"pairs", totals.pairs},
          {"colliding_spheres", totals.colliding_spheres},
          {"fingerprint", hex64(totals.fingerprint.a) + hex64(totals.fingerprint.b)},
          {"width", image.width},
          {"height", image.height},
          {"box", image.box ? json{{"low", image.box->low}, {"high", image.box->high}} : json()},
          {"camera", to_json(image.camera)},
          {"samples", views}};
}

// Encodes and writes images while the next ones are drawn; without threads, when finish_one() waits for them. That is
// also when their exceptions are thrown.
class Writers {
 public:
  void write(const fs::path& path, std::vector<uint> pixels, const ImageOptions& image, const json& record) {
    if (jobs_.size() >= std::max(1u, std::thread::hardware_concurrency())) finish_one();
    jobs_.push_back(std::async([=, pixels = std::move(pixels), width = image.width, height = image.height] {
      write_png(path, pixels, width, height);
      write_file(record_of(path), json_text(record));
    }));
  }
  void finish() {
    while (!jobs_.empty()) finish_one();
  }

 private:
  void finish_one() {
    std::future<void> job = std::move(jobs_.front());
    jobs_.pop_front();
    job.get();
  }
  std::deque<std::future<void>> jobs_;
};

std::vector<uint> draw_step(const Series& series, uint64_t step, json& image_record) {
  Backend& backend = *series.chosen.backend;
  CollideOptions collide = {.method = series.method};
  if (series.image.look.lighting) collide.grid.cells = Cells::dense;
  require_finite(current_state(backend), step);
  backend.collide(collide);
  image_record = record(series, step, backend.collisions());
  std::vector<uint> image = draw_image(backend, series.image);
  image_record["transfer"] = transfer_taken(backend);
  if (series.options.legend) draw_legend(image, series.image.width, series.image.height, series.image.look);
  return image;
}

void draw_series(const Series& series) {
  const RenderOptions& options = series.options;
  Progress progress;
  Writers writers;
  std::optional<Video> video;
  const fs::path video_path = options.video_file;
  if (!video_path.empty()) video.emplace(video_path, options.width, options.height, options.images_per_second);
  uint64_t step = series.start.step + options.steps;
  json first, current;
  for (uint64_t k = 0; k < options.images; ++k) {
    progress.say(fmt::format("image {} of {}, step {}", k + 1, options.images, step));
    std::vector<uint> image = draw_step(series, step, current);
    if (k == 0) first = current;
    if (video) video->add(image);
    if (!options.output_file.empty()) writers.write(name_of(options, k), std::move(image), series.image, current);
    if (k + 1 == options.images) break;
    for (uint64_t i = 0; i < options.every; ++i, ++step) series.chosen.backend->move();
  }
  writers.finish();
  if (!video) return;
  video->commit();
  first.update({{"images", options.images}, {"every", options.every}, {"rate", options.images_per_second}});
  write_file(record_of(video_path), json_text(first));
}

}  // namespace

int render_command(const CommandLine& line, const RenderOptions& options) {
  check_options(options);
  const Start start = start_of(options.start, line.open.threads);
  const ChosenBackend chosen = choose_backend(options.backend, line.open);
  const bool lights = !options.plain && options.draw == "compute" && start.scene.size() > 1;
  const Method method = lights ? Method::collide_grid : choose_method(options.method, *chosen.backend);
  for (const std::string& warning : chosen.session->warnings()) fmt::print(stderr, "{}\n", warning);
  upload_start(start, *chosen.backend);
  const double aspect = double(options.width) / options.height;
  for (uint64_t step = 0; step < options.steps; ++step) chosen.backend->move();
  const Backend::State state = current_state(*chosen.backend);
  require_finite(state, start.step + options.steps);
  const Bounds bounds = bounds_of(state.positions);
  const Camera camera = camera_of(options.camera, bounds, aspect);
  Look look = contact_look();
  if (lights) look.lighting = LIGHT_OCCLUSION | LIGHT_SHADOW | LIGHT_GROUND;
  ImageOptions image{camera, look, options.width, options.height, options.samples, draw_method_from_name(options.draw)};
  if (options.box && image.method == DrawMethod::compute && start.scene.size() > 0) image.box = bounds;
  if (lights) image.ground = start.scene.plane;
  draw_series({line, options, start, chosen, method, image});
  fmt::print("{}{} on {}: scene {}, {} spheres\n", start.notes, chosen.backend->info().name,
             device_label(chosen.backend->info()), start.label, start.scene.size());
  fmt::print("{}", passed_over_text(chosen));
  if (image.method != DrawMethod::compute)
    fmt::print("drawn by {} in OpenGL{}\n", draw_method_name(image.method), transfer_in_words(*chosen.backend));
  if (!options.output_file.empty() && options.images > 1)
    fmt::print("{} to {}\n", name_of(options, 0).string(), name_of(options, options.images - 1).string());
  if (!options.output_file.empty() && options.images == 1) fmt::print("{}\n", options.output_file);
  if (!options.video_file.empty()) fmt::print("{}\n", options.video_file);
  return kOk;
}

}  // namespace spherepair
