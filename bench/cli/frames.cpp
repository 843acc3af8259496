// SPDX-License-Identifier: MIT
// spherepair frames: times of drawing, as JSON of the format "spherepair frames 1":
//   context, backends, clocks   as in results.json of compare; width, height, packing_fraction
//   frames     one entry a measurement:
//     n, backend, draw (DrawMethod), place (outside | inside: of the camera),
//     work (frame: one picture from a new place; frame_all: the same with nothing skipped; lit: with ambient occlusion,
//     shadows and the ground; loop: move, collide_grid and frame, the first 20 steps), and the timing core's fields:
//     median_ms, interval_ms, samples_ms, batch, device_stages_ms ... image: hash of a check picture, equal for all
//     that draw exactly; counts: what that picture left out. From CUDA to OpenGL (--hand-over): draw is none for the
//     hand-over alone and for `step` (move and collide_grid alone); work is host, registered or imported (Transfer),
//     each picture waited for, or the same with _pipelined: hand-over, picture and step, nothing waited for but by the
//     hand-over
//   overlaps   of --hand-over: n, draw, transfer, picture_ms, step_ms, pipelined_ms, and of the shorter of picture and
//     step the share that the pipelined loop hides: overlap
//   left_out   n, backend, draw and the reason, of all that was asked for and not timed
#include "bench/studies/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>

#include "api/open.h"
#include "bench/check/step_result.h"
#include "bench/cli/commands.h"
#include "bench/formats/files.h"
#include "bench/io/arguments.h"
#include "bench/io/context.h"
#include "bench/io/numbers.h"
#include "bench/io/output_files.h"
#include "common/backend/shared_drawing.h"
#include "common/shared/hash.h"

namespace spherepair {
namespace {

DrawOptions draw_options(const FrameTask& task, bool count = false) {
  const bool ablations = task.work != "frame_all";
  DrawOptions options = {.method = task.draw, .reuse_unchanged = false, .count = count};
  options.frustum_culling = options.occlusion_culling = options.skip_tile_launches = options.overlap = ablations;
  return options;
}

uint64_t image_hash(const std::vector<uint>& image) {
  uint64_t hash = 0;
  for (const uint pixel : image) hash = splitmix64(hash ^ pixel);
  return hash;
}

json to_json(const DrawStatistics& counts) {
  return {{"drawn", counts.drawn},
          {"unseen", counts.unseen},
          {"large", counts.large},
          {"tiles", counts.tiles},
          {"hidden", counts.hidden},
          {"undrawable", counts.undrawable},
          {"clusters", counts.clusters},
          {"clusters_outside", counts.clusters_outside},
          {"clusters_hidden", counts.clusters_hidden},
          {"clusters_deferred", counts.clusters_deferred},
          {"bundles_left_out", counts.bundles_left_out}};
}

// Of a sample: spheres fall and crowd, so every sample, of all backends, takes the same steps from the start.
constexpr uint64_t steps_of_loop = 20;

class Bench {
 public:
  Bench(Session& session, const FramesOptions& options, const OpenOptions& open)
      : session_(session), options_(options), open_(open) {
    sampling_.rounds = options.rounds;
    for (const std::string& text : options.most) {
      const size_t colon = text.find(':');
      const auto n = whole_number_of(text.substr(std::min(colon, text.size() - 1) + 1), 1, kMostSpheres);
      if (!n) throw std::invalid_argument(fmt::format("--most {}: not a method and a number, mesh:1000", text));
      most_[draw_method_name(draw_method_from_name(text.substr(0, colon)))] = *n;
    }
    if (options.min_seconds > 0) sampling_.hardware_seconds = sampling_.software_seconds = options.min_seconds;
  }

  void measure_size(uint64_t n) {
    SceneOptions named = {.name = "uniform", .n = n};
    named.packing_fraction = options_.packing_fraction;
    const Scene scene = in_cell_order(make_scene(named));
    const Bounds bounds = bounds_of(scene.positions);
    for (const auto& backend : session_.backends()) {
      try {
        backend->upload(scene);
        backend->collide(in_dense_cells(*backend, n));
      } catch (const BackendError& error) {
        leave_out(n, *backend, "all", error.what());
        continue;
      }
      for (const std::string& place : options_.places) measure_place(n, *backend, scene, bounds, place);
      if (options_.transfer && backend->info().name == "cuda") measure_shared(n, *backend, scene, bounds);
      backend->upload(make_scene({.n = 0}));  // its memory is the next one's
    }
  }

  json frames = json::array(), left_out = json::array(), overlaps = json::array();

 private:
  void leave_out(uint64_t n, const Backend& backend, const std::string& draw, const std::string& reason) {
    left_out.push_back({{"n", n}, {"backend", backend.info().name}, {"draw", draw}, {"reason", reason}});
  }

  bool beyond_most(uint64_t n, const std::string& draw) const {
    const auto most = most_.find(draw);
    return most != most_.end() && n > most->second;
  }

  void measure_place(uint64_t n, Backend& backend, const Scene& scene, const Bounds& bounds, const std::string& place) {
    for (const std::string& draw : options_.draws)
      for (const std::string& work : options_.works) {
        const FrameTask task{&backend, draw_method_from_name(draw), place, work};
        const bool lit = work == "lit";
        if ((lit || work == "frame_all") && task.draw != DrawMethod::compute) continue;
        if (std::ranges::count(backend.draw_methods(), task.draw) == 0) {
          leave_out(n, backend, draw, "this backend has it not");
        } else if (beyond_most(n, draw)) {
          leave_out(n, backend, draw, "beyond --most");
        } else {
          const uint light = lit ? LIGHT_OCCLUSION | LIGHT_SHADOW | LIGHT_GROUND : 0;
          measure_task(n, task, scene, way(bounds, place, options_.width, options_.height, light));
        }
      }
  }

  void measure_task(uint64_t n, const FrameTask& task, const Scene& scene, const std::vector<View>& views) {
    progress_.say(fmt::format("{} spheres, {}", n, label(task)));
    json entry = {{"n", n},
                  {"backend", task.backend->info().name},
                  {"draw", draw_method_name(task.draw)},
                  {"place", task.place},
                  {"work", task.work}};
    check(task, views, entry);
    uint64_t turn = 0;
    const auto image = [&](Backend& backend) {
      backend.enqueue_draw(views[turn++ % views.size()], draw_options(task));
    };
    Contender contender{label(task), task.backend, image};
    if (task.work == "loop") {
      contender.step = [&](Backend& backend) {
        backend.move();
        backend.enqueue_collide(in_dense_cells(backend, n));
        image(backend);
      };
      contender.restart = [&](Backend& backend) {
        turn = 0;
        backend.upload(scene);
        contender.step(backend);
      };
      contender.batch = steps_of_loop;
    }
    entry.update(to_json(measure({&contender, 1}, sampling_, progress_).front()));
    frames.push_back(entry);
    print(entry);
    if (task.work != "loop") return;
    task.backend->upload(scene);  // back to where the spheres were
    task.backend->collide(in_dense_cells(*task.backend, n));
  }

  // CUDA's spheres through OpenGL.
  void measure_shared(uint64_t n, Backend& cuda, const Scene& scene, const Bounds& bounds) {
    SharedTask task{&cuda, in_dense_cells(cuda, n), way(bounds, "outside", options_.width, options_.height, 0), {}};
    for (const std::string& draw : options_.draws)
      if (draw != draw_method_name(DrawMethod::compute) && !beyond_most(n, draw))
        task.draws.push_back(draw_method_from_name(draw));
    const auto time = [&](const std::string& draw, const std::string& work, const std::function<void()>& step) {
      json entry = {{"n", n}, {"backend", "cuda to glsl"}, {"draw", draw}, {"place", "outside"}, {"work", work}};
      const Contender contender{fmt::format("cuda to glsl {} {}", draw, work), &cuda, [&](Backend&) { step(); }};
      progress_.say(contender.label);
      const Samples samples = measure({&contender, 1}, sampling_, progress_).front();
      entry.update(to_json(samples));
      frames.push_back(entry);
      print(entry);
      return samples.median_seconds();
    };
    const std::unique_ptr<SharedDrawing> shared = open_shared_drawing(cuda, open_);
    for (json& overlap : time_transfers(task, *shared, time)) {
      overlap["n"] = n;
      overlaps.push_back(overlap);
    }
    cuda.upload(scene);
    cuda.collide(in_dense_cells(cuda, n));
  }

  // Exact pictures must agree between backends and whatever is skipped. The third from one place skips all it can, and
  // is counted; what is compared is the second of two that are drawn as they are timed.
  void check(const FrameTask& task, const std::vector<View>& views, json& entry) {
    const bool exact = task.draw == DrawMethod::compute;
    for (int time = 0; exact && time < 3; ++time) task.backend->draw(views.front(), draw_options(task, true));
    if (exact && task.backend->info().name != "cpu") entry["counts"] = to_json(task.backend->draw_statistics());
    for (int time = 0; time < 2; ++time) task.backend->draw(views.front(), draw_options(task));
    const json image = entry["image"] = hex64(image_hash(task.backend->image()));
    for (const json& other : frames)
      if (other.at("n") == entry.at("n") && other.at("place") == task.place && other.at("draw") == "compute" && exact &&
          (other.at("work") == "lit") == (task.work == "lit") && other.at("image") != image)
        throw DifferenceFound(
            fmt::format("{}: the picture differs from that of {}", label(task), other.at("label").get<std::string>()),
            entry);
  }

  void print(const json& entry) {
    progress_.clear();
    fmt::print("{:>11}  {:<38} {:>10} ms\n", entry.at("n").get<uint64_t>(), entry.at("label").get<std::string>(),
               format_number(entry.at("median_ms")));
    std::fflush(stdout);
  }

  Session& session_;
  const FramesOptions& options_;
  const OpenOptions& open_;
  std::map<std::string, uint64_t> most_;
  Sampling sampling_;
  Progress progress_;
};

}  // namespace

std::string label(const FrameTask& task) {
  return fmt::format("{} {} {} {}", task.backend->info().name, draw_method_name(task.draw), task.place, task.work);
}

int frames_command(const CommandLine& line, const FramesOptions& options) {
  require_known_backends(options.backends);
  for (const std::string& draw : options.draws) draw_method_from_name(draw);
  for (const std::string& place : options.places) require_known("place of the camera", place, {"outside", "inside"});
  for (const std::string& work : options.works) require_known("work", work, {"frame", "frame_all", "lit", "loop"});
  OutputFiles().write("--json", options.json_file);
  Session session(options.backends, line.open, line.opener);
  fmt::print("{}\n", session.summary());
  json record = {{"format", "spherepair frames 1"}, {"context", capture_context(line.words)},
                 {"backends", session.to_json()},   {"width", options.width},
                 {"height", options.height},        {"packing_fraction", options.packing_fraction}};
  Bench bench(session, options, line.open);
  for (const uint64_t n : options.sizes) {
    bench.measure_size(n);
    record["clocks"].push_back(query_clocks());
    record["frames"] = bench.frames;
    record["left_out"] = bench.left_out;
    if (options.transfer) record["overlaps"] = bench.overlaps;
    write_file(options.json_file, json_text(record));
  }
  fmt::print("{}\n", options.json_file);
  return kOk;
}

}  // namespace spherepair
