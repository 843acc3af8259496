// SPDX-License-Identifier: MIT
// spherepair render
#include <fmt/format.h>

#include <algorithm>

#include "bench/check/finite_state.h"
#include "bench/check/step_result.h"
#include "bench/cli/commands.h"
#include "bench/formats/files.h"
#include "bench/formats/video.h"
#include "bench/image/colour_values.h"
#include "bench/image/drawing_scale.h"
#include "bench/image/ground.h"
#include "bench/image/image_files.h"
#include "bench/image/image_record.h"
#include "bench/io/arguments.h"
#include "bench/io/context.h"
#include "bench/io/output_files.h"
#include "bench/measure/choice.h"
#include "common/backend/checks.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

namespace fs = std::filesystem;

// A series of images: steps of a run, or frames of a file.
struct Series {
  const CommandLine& line;
  const RenderOptions& options;
  const std::vector<Start>& starts;  // one, or one a frame
  const ChosenBackend& chosen;
  Method method;
  bool lights;
  ImageOptions image = {};
  std::optional<Colouring> colouring = {};
  std::optional<LegendStrip> strip = {};

  Backend& backend() const { return *chosen.backend; }
  Drawing& drawing() const { return drawing_of(backend()); }
  uint64_t images() const { return options.frames ? starts.size() : options.images; }
  const Start& start(uint64_t k) const { return starts[options.frames ? k : 0]; }
  uint64_t step(uint64_t k) const { return start(k).step + options.steps + (options.frames ? 0 : k * options.every); }
  fs::path file(uint64_t k) const { return numbered(options.output_file, k, images()); }
  ColourBy by() const { return colour_by_name(options.colour); }
};

json record(const Series& series, uint64_t k, const Legend& legend) {
  json all = {{"format", record_format},
              {"context", capture_context(series.line.words)},
              {"backends", series.chosen.session->to_json()},
              {"step", series.step(k)},
              {"width", series.options.width},
              {"height", series.options.height}};
  all.update(image_record(series.start(k), series.backend(), series.method, series.image, legend));
  return all;
}

// Brings the backend to the spheres of image k and finds their pairs. Call it for one image after the other.
Motion::State advance(const Series& series, uint64_t k) {
  Backend& backend = series.backend();
  if (series.options.frames || k == 0) upload_start(series.start(k), backend);
  const uint64_t steps = series.options.frames ? 0 : k == 0 ? series.options.steps : series.options.every;
  for (uint64_t step = 0; step < steps; ++step) backend.move();
  Motion::State state = current_state(backend);
  require_finite(state, series.step(k));
  backend.collide({.method = series.method});
  return state;
}

// The facts in the legend of image k. pairs: their number, or an upper bound.
std::vector<std::string> facts_of(const Series& series, uint64_t k, uint64_t pairs) {
  const Start& start = series.start(k);
  std::vector<std::string> facts = {counted(start.scene.size(), "sphere"), counted(pairs, "pair")};
  if (series.options.frames) facts.push_back(fmt::format("frame {} (0 to {})", k, series.images() - 1));
  if (start.at_rest) return facts;
  facts.push_back(fmt::format("step {}", series.step(k)));
  facts.push_back(fmt::format("{:.4g} s", double(series.step(k)) * double(start.scene.dt)));
  return facts;
}

// The widest legend of all images, so that each has room for its own.
Legend widest_legend(const Series& series) {
  Legend legend = series.colouring->legend();
  uint64_t most = 0;
  for (const Start& start : series.starts) most = std::max<uint64_t>(most, start.scene.size());
  legend.facts = facts_of(series, series.images() - 1, std::max(series.backend().collisions().pairs, 8 * most));
  legend.facts[0] = counted(most, "sphere");
  return legend;
}

// Chooses colours, legend, camera, box and ground from the first image's spheres or from all frames: the same for all
// images.
void compose(Series& series, const Motion::State& first, const std::vector<double>& values) {
  const RenderOptions& options = series.options;
  series.colouring = colouring_of(series.by(), series.starts, values, options.colour_range.has_value());
  if (options.legend) series.strip = LegendStrip::within(widest_legend(series), options.width, options.height);
  ImageOptions& image = series.image;
  image.width = options.width;
  image.height = options.height - (series.strip ? series.strip->height() : 0);
  image.samples = options.samples;
  image.method = draw_method_from_name(options.draw);
  const Bounds bounds = bounds_of_all(series.starts, first.positions);
  image.camera = camera_of(options.camera, bounds, double(image.width) / image.height);
  image.look = series.colouring->look();
  if (options.box) image.box = bounds;
  if (!series.lights) return;
  image.look.lighting = LIGHT_OCCLUSION | LIGHT_SHADOW;
  place_ground(image.look, options.ground, series.starts, first.positions, image.camera.up);
}

// The values that choose the colours of all images: --color-range, or a sample of the speeds or contacts in all images
// of a video. For the sample the run is made once before it is drawn. Empty: the first image's values choose.
std::vector<double> values_for_colours(const Series& series, Progress& progress) {
  const auto& range = series.options.colour_range;
  if (range) return {range->front(), range->back()};
  const bool varies = series.by() == ColourBy::speed || series.by() == ColourBy::contacts;
  if (series.options.frames || series.images() == 1 || !varies) return {};
  constexpr uint64_t most = 1 << 22;
  const uint64_t stride = series.images() * series.start(0).scene.size() / most + 1;
  std::vector<double> sample;
  for (uint64_t k = 0; k < series.images(); ++k) {
    progress.say(fmt::format("range of the colours: image {} of {}", k + 1, series.images()));
    const Motion::State state = advance(series, k);
    const std::vector<double> values = values_of(series.by(), series.start(k), series.backend(), state);
    for (uint64_t i = 0; i < values.size(); i += stride) sample.push_back(values[i]);
  }
  return series.by() == ColourBy::speed ? range_of_speeds(std::move(sample)) : sample;
}

void require_spheres(const Series& series, uint64_t k, bool some) {
  if (some || k > 0) return;
  refuse_blank_image(series.start(0), current_state(series.backend()).positions);
}

// Remarks about all images: images without a sphere, and values beyond the colours' range.
struct Remarks {
  uint64_t blank = 0, beyond = 0;
  std::string undrawn = {};  // in the first image
  double highest = 0;
};

std::vector<uint> draw_one(const Series& series, uint64_t k, const std::vector<double>& values, json& image_record,
                           Remarks& remarks) {
  series.drawing().set_classes(series.colouring->classes(values));
  DrawnImage drawn = draw_image(series.drawing(), series.image);
  require_spheres(series, k, !drawn.blank);
  remarks.blank += drawn.blank;
  const double highest = values.empty() ? 0 : std::ranges::max(values);
  remarks.beyond += highest > series.colouring->highest();
  remarks.highest = std::max(remarks.highest, highest);
  Legend legend = series.colouring->legend();
  legend.facts = facts_of(series, k, series.backend().collisions().pairs);
  image_record = record(series, k, legend);
  if (series.strip) series.strip->append_to(drawn.pixels, legend);
  return std::move(drawn.pixels);
}

Remarks draw_series(Series& series) {
  const RenderOptions& options = series.options;
  Progress progress;
  ImageWriters writers;
  std::optional<Video> video;
  Remarks remarks;
  json first, current;
  const std::vector<double> chosen = values_for_colours(series, progress);
  for (uint64_t k = 0; k < series.images(); ++k) {
    progress.say(fmt::format("image {} of {}{}", k + 1, series.images(),
                             options.frames ? "" : fmt::format(", step {}", series.step(k))));
    const Motion::State state = advance(series, k);
    const std::vector<double> values = values_of(series.by(), series.start(k), series.backend(), state);
    if (k == 0) require_spheres(series, k, !values.empty());
    if (k == 0) compose(series, state, chosen.empty() ? values : chosen);
    if (k == 0) remarks.undrawn = undrawn_text(series.start(0), state.positions);
    std::vector<uint> image = draw_one(series, k, values, current, remarks);
    if (k == 0) first = current;
    if (k == 0 && !options.video_file.empty())
      video.emplace(options.video_file, options.width, options.height, options.images_per_second);
    if (video) video->add(image);
    if (!options.output_file.empty()) writers.write(series.file(k), std::move(image), options.width, current);
  }
  writers.finish();
  if (!video) return remarks;
  video->commit();
  first.update({{"images", series.images()}, {"every", options.every}, {"rate", options.images_per_second}});
  write_file(record_of(options.video_file), json_text(first));
  return remarks;
}

void print_summary(const Series& series, const Remarks& remarks) {
  const RenderOptions& options = series.options;
  const BackendInfo& info = series.backend().info();
  const Start& first = series.start(0);
  fmt::print("{}{} on {}: scene {}, {}\n{}{}", options.frames ? "" : first.notes, info.name, device_label(info),
             first.label, counted(first.scene.size(), "sphere"), passed_over_text(series.chosen),
             describe_contacts(first.scene));
  if (series.image.method != DrawMethod::compute)
    fmt::print("drawn by {} in OpenGL{}{}\n", options.draw, transfer_in_words(series.drawing()),
               series.lights ? ", without ambient occlusion and shadows on the spheres: --draw compute has both" : "");
  if (!series.colouring->grouping().empty()) fmt::print("{}\n", series.colouring->grouping());
  if (remarks.beyond)
    fmt::print("{} up to {:.4g} are beyond the range of the colours in {} of {}: they have the last colour\n",
               options.colour, remarks.highest, remarks.beyond, counted(series.images(), "image"));
  if (options.legend && !series.strip)
    fmt::print("{}x{} pixels have no room for the legend: it is left out\n", options.width, options.height);
  fmt::print("{}", remarks.undrawn);
  if (remarks.blank) fmt::print("no sphere is in {} of {}\n", remarks.blank, counted(series.images(), "image"));
  if (!options.output_file.empty())
    fmt::print("{}{}\n", series.file(0).string(),
               series.images() > 1 ? " to " + series.file(series.images() - 1).string() : "");
  if (!options.video_file.empty()) fmt::print("{}\n", options.video_file);
}

}  // namespace

int render_command(const CommandLine& line, const RenderOptions& given) {
  check_render_options(given);
  RenderOptions options = given;
  options.start.species = colour_by_name(options.colour) == ColourBy::species;
  std::vector<Start> starts;
  if (options.frames) {
    starts = start_of_frames(options.start, line.open.threads);
    check_render_files(options, starts.size());
  } else {
    starts.push_back(start_of(options.start, line.open.threads));
  }
  if (options.steps > 0 || options.images > 1) starts.front().at_rest = false;  // the spheres fall
  fit_for_drawing(starts, options.camera, options.ground);
  const ChosenBackend chosen = choose_backend(options.backend, line.open);
  const bool by_grid = !options.plain && options.method.empty();  // light uses the grid's cells
  const Method method = by_grid ? Method::collide_grid : choose_method(options.method, *chosen.backend);
  if (starts.front().scene.contact.periodic) check_images({.method = method});
  for (const std::string& warning : chosen.session->warnings()) fmt::print(stderr, "{}\n", warning);
  Series series{line, options, starts, chosen, method, !options.plain};
  print_summary(series, draw_series(series));
  return kOk;
}

}  // namespace spherepair
