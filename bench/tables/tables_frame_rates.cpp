// SPDX-License-Identifier: MIT
// The original paper's Table 1, frames per second and drawing: move, find the pairs, draw, without a display's limit.
// Sequential: one thread of the CPU, one draw a sphere. Parallel: a GPU API, one instanced draw.
#include <fmt/format.h>

#include <algorithm>

#include "api/open.h"
#include "bench/tables/paper_rows.h"
#include "bench/tables/study.h"
#include "common/scene/camera.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

constexpr uint width = 1280, height = 720;  // the paper does not give its size

// A version of the paper's program. Each draws by the first of its methods.
struct Version {
  std::string name;
  Backend* backend;
  Method pairs;
  std::vector<DrawMethod> draws;
};

std::vector<Version> versions_of(const Study& study, Backend& one_thread) {
  std::vector<Version> versions = {
      {"sequential", &one_thread, Method::sequential, {DrawMethod::mesh_each, DrawMethod::quadric}}};
  for (Backend* device : study.session.devices())
    if (device->drawing() && std::ranges::count(device->drawing()->draw_methods(), DrawMethod::mesh) != 0)
      versions.push_back({device->info().name, device, Method::collide_tiled, {DrawMethod::mesh}});
  return versions;
}

// Frames of a sample: fewer with more spheres, and fewer in software. Every version and every sample has the same
// frames, since falling spheres become denser.
uint64_t frames_per_sample(uint64_t n, bool hardware) {
  return std::clamp<uint64_t>((hardware ? 65536 : 8192) / n, 2, 64);
}

View view_of(const Scene& scene) {
  return make_view(frame(bounds_of(scene.positions), 30, 20, 40, double(width) / height), contact_look(), width,
                   height);
}

void draw(Backend& backend, DrawMethod method, const View& view) {
  drawing_of(backend).enqueue_draw(view, {.method = method, .reuse_unchanged = false});
}

// Checks that every backend draws the same mesh, in one draw or many.
void require_equal_images(const std::vector<Version>& versions, const Scene& scene, const View& view) {
  std::vector<uint> expected;
  for (const Version& version : versions) {
    version.backend->upload(scene);
    version.backend->collide({.method = version.pairs});
    Drawing& drawing = drawing_of(*version.backend);
    drawing.draw(view, {.method = version.draws.front()});
    const std::vector<uint> image = drawing.image();
    if (expected.empty()) expected = image;
    if (image != expected)
      throw DifferenceFound(fmt::format("frame_rates: {} drawn by {} {} and by {} {} give different images",
                                        counted(scene.size(), "sphere"), versions.front().name,
                                        draw_method_name(versions.front().draws.front()), version.name,
                                        draw_method_name(version.draws.front())),
                            {{"n", scene.size()}});
  }
}

std::vector<Contender> contenders_of(const std::vector<Version>& versions, const Scene& scene, const View& view,
                                     bool hardware) {
  std::vector<Contender> contenders;
  for (const Version& version : versions) {
    for (const DrawMethod method : version.draws)
      contenders.push_back({.label = fmt::format("{} {}", version.name, draw_method_name(method)),
                            .backend = version.backend,
                            .step = [=](Backend& backend) { draw(backend, method, view); },
                            .contest = draw_method_name(method)});
    contenders.push_back({.label = version.name + " frame",
                          .backend = version.backend,
                          .step =
                              [=](Backend& backend) {
                                backend.move();
                                backend.enqueue_collide({.method = version.pairs});
                                draw(backend, version.draws.front(), view);
                              },
                          .contest = "frame",
                          .restart =
                              [&scene, version](Backend& backend) {
                                backend.upload(scene);
                                backend.collide({.method = version.pairs});
                              },
                          .batch = frames_per_sample(scene.size(), hardware)});
  }
  return contenders;
}

const Samples& find(const std::vector<Samples>& samples, const std::string& label) {
  return *std::ranges::find(samples, label, &Samples::label);
}

Table rates_table(const std::vector<Version>& versions) {
  Table table{"Table 1: frames per second, random scene", {{"", "n", ""}, {"", "paper", "1/s"}}, {}, {}};
  for (const Version& version : versions) table.columns.push_back({"median", version.name, "1/s"});
  table.notes = {fmt::format(
      "A frame: motion, pairs and an image of {} x {} pixels, with no display to wait for. sequential: one thread of "
      "the CPU, one draw a sphere, its spheres transferred to OpenGL for each image. The others: collide_tiled and one "
      "instanced draw; CUDA's spheres are transferred for each image too. A backend without OpenGL's pipeline, as "
      "vulkan, is not among them.",
      width, height)};
  return table;
}

Table drawing_table(const std::vector<Version>& versions) {
  Table table{"Table 1: drawing, random scene", {{"", "n", ""}}, {}, {}};
  for (const char* name : {"sequential", "parallel"}) table.columns.push_back({"the paper's", name, "ms"});
  for (const Version& version : versions)
    for (const DrawMethod method : version.draws)
      table.columns.push_back({version.name, draw_method_name(method), "ms"});
  table.notes = {
      "mesh_each and mesh: the paper's 80 triangles; quadric: glutSolidSphere's 180. The paper's 60 frames per second "
      "and 0 ms are the limits of its display and of its clock."};
  return table;
}

// Checks the images, then times drawing and whole frames.
std::vector<Samples> time_frames(Study& study, const std::vector<Version>& versions, uint64_t n) {
  const Scene scene = make_scene(study.paper_scene(n));
  const View view = view_of(scene);
  require_equal_images(versions, scene, view);
  const size_t first = study.measurements.size();
  const std::vector<Contender> contenders = contenders_of(versions, scene, view, study.plan.hardware);
  const std::vector<Samples> samples = study.time_unchecked(
      "frame_rates", contenders, {{"work", "frame"}, {"n", n}, {"width", width}, {"height", height}});
  for (size_t k = 0; k < samples.size(); ++k)
    if (!contenders[k].restart) study.measurements[first + k]["work"] = "draw";
  return samples;
}

std::string rate_of(const Samples& frame) {
  std::vector<double> rates;
  for (const double seconds : frame.seconds) rates.push_back(1 / seconds);
  return time_cell(rates, 1, frame.unsteady().empty());
}

std::vector<std::string> rates_row(const std::vector<Version>& versions, uint64_t n,
                                   const std::vector<Samples>& samples) {
  std::vector<std::string> cells = {std::to_string(n), paper_row(n).fps};
  for (const Version& version : versions) cells.push_back(rate_of(find(samples, version.name + " frame")));
  return cells;
}

std::vector<std::string> drawing_row(const std::vector<Version>& versions, uint64_t n,
                                     const std::vector<Samples>& samples) {
  const PaperRow paper = paper_row(n);
  std::vector<std::string> cells = {std::to_string(n), paper.sequential_drawing, paper.parallel_drawing};
  for (const Version& version : versions)
    for (const DrawMethod method : version.draws)
      cells.push_back(time_cell(find(samples, fmt::format("{} {}", version.name, draw_method_name(method)))));
  return cells;
}

}  // namespace

std::vector<Table> make_frame_rates(Study& study) {
  OpenOptions open = study.session.options();
  open.threads = 1;
  const auto one_thread = open_backend("cpu", open);
  const std::vector<Version> versions = versions_of(study, *one_thread);
  Table rates = rates_table(versions), drawing = drawing_table(versions);
  SizeSequence sizes(study, study.plan.paper_sizes);
  try {
    while (sizes.next()) {
      const std::vector<Samples> samples = time_frames(study, versions, sizes.n());
      sizes.measured(samples);
      rates.rows.push_back(rates_row(versions, sizes.n(), samples));
      drawing.rows.push_back(drawing_row(versions, sizes.n(), samples));
    }
  } catch (const BackendError& error) {
    drawing.notes.push_back(fmt::format("Left out: {}", error.what()));
  }
  for (const std::string& note : sizes.notes()) drawing.notes.push_back(note);
  return {rates, drawing};
}

}  // namespace spherepair
