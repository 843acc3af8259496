// SPDX-License-Identifier: MIT
#include "bench/studies/frames_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "bench/check/step_result.h"
#include "bench/io/numbers.h"
#include "bench/studies/study_sampling.h"
#include "common/scene/counted.h"
#include "common/shared/hash.h"

namespace spherepair {
namespace {

DrawOptions draw_options(const FrameTask& task, bool count = false) {
  const bool optimised = task.work != "frame_all";
  DrawOptions options = {.method = task.draw, .reuse_unchanged = false, .count = count};
  options.frustum_culling = options.occlusion_culling = options.skip_tile_launches = options.overlap = optimised;
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

// Falling spheres become denser, so every sample on every backend takes the same steps from the start.
constexpr uint64_t steps_of_loop = 20;

}  // namespace

std::function<void(Backend&)> start_of_loop(const Scene& scene) {
  return [&scene](Backend& backend) {
    backend.upload(scene);
    backend.collide(in_dense_cells(backend, scene.size()));
  };
}

std::string label(const FrameTask& task) {
  return fmt::format("{} {} {} {}", task.backend->info().name, draw_method_name(task.draw), task.place, task.work);
}

std::map<std::string, uint64_t> most_by_draw(const std::vector<std::string>& limits) {
  std::map<std::string, uint64_t> most;
  for (const std::string& text : limits) {
    const size_t colon = text.find(':');
    const auto n = count_of(text.substr(std::min(colon, text.size() - 1) + 1), 1, kMostSpheres);
    if (!n) throw std::invalid_argument(fmt::format("--most {} is not METHOD:NUMBER, such as mesh:1000", text));
    const std::string draw = draw_method_name(draw_method_from_name(text.substr(0, colon)));
    if (!most.emplace(draw, *n).second)
      throw std::invalid_argument(fmt::format("--most has {} more than once: name it once", draw));
  }
  return most;
}

FramesStudy::FramesStudy(Session& session, const FramesOptions& options)
    : session_(session), options_(options), most_(most_by_draw(options.most)) {
  sampling_ = study_sampling(options.rounds);
  if (options.min_seconds > 0) sampling_.hardware_seconds = sampling_.software_seconds = options.min_seconds;
}

void FramesStudy::measure_size(uint64_t n) {
  SceneOptions uniform = {.name = "uniform", .n = n};
  uniform.packing_fraction = options_.packing_fraction;
  const Scene scene = in_cell_order(make_scene(uniform));
  const Bounds bounds = bounds_of(scene.positions);
  std::vector<Backend*> backends;
  for (const auto& backend : session_.backends()) {
    try {
      start_of_loop(scene)(*backend);
      backends.push_back(backend.get());
    } catch (const BackendError& error) {
      leave_out(n, *backend, "all", error.what());
    }
  }
  for (const std::string& place : options_.places) measure_place(n, backends, scene, bounds, place);
  for (Backend* backend : backends) backend->upload(make_scene({.n = 0}));  // frees its memory
  if (!options_.transfer) return;
  for (Backend* backend : backends)
    if (backend->drawing() && backend->drawing()->transfers().size() > 1) measure_transfers(n, *backend, scene, bounds);
  measure_exchanges(n, scene);
}

void FramesStudy::leave_out(uint64_t n, const Backend& backend, const std::string& draw, const std::string& reason) {
  left_out.push_back({{"n", n}, {"backend", backend.info().name}, {"draw", draw}, {"reason", reason}});
}

bool FramesStudy::beyond_most(uint64_t n, const std::string& draw) const {
  const auto most = most_.find(draw);
  return most != most_.end() && n > most->second;
}

void FramesStudy::measure_place(uint64_t n, const std::vector<Backend*>& backends, const Scene& scene,
                                const Bounds& bounds, const std::string& place) {
  for (const std::string& draw : options_.draws)
    for (const std::string& work : options_.works) {
      const DrawMethod method = draw_method_from_name(draw);
      const bool lit = work == "lit";
      if ((lit || work == "frame_all") && method != DrawMethod::compute) continue;
      Look look = contact_look();
      if (lit) look.lighting = LIGHT_OCCLUSION | LIGHT_SHADOW | LIGHT_GROUND;
      look.ground = double(scene.plane);
      const std::vector<View> views = camera_path(bounds, place, options_.width, options_.height, look);
      std::vector<FrameTask> tasks;
      for (Backend* backend : backends) {
        const FrameTask task{backend, method, place, work};
        const Drawing* drawing = backend->drawing();
        if (!drawing || std::ranges::count(drawing->draw_methods(), method) == 0) {
          leave_out(n, *backend, draw, "this backend does not have it");
        } else if (beyond_most(n, draw)) {
          leave_out(n, *backend, draw, "beyond --most");
        } else {
          try {
            check(n, task, views);
            tasks.push_back(task);
          } catch (const BackendError& error) {
            if (method == DrawMethod::compute) throw;
            leave_out(n, *backend, draw, error.what());  // no OpenGL to transfer the spheres to
          }
        }
      }
      if (!tasks.empty()) measure_tasks(tasks, scene, views);
    }
}

// Times the same work on several backends, whose entries are the last of `frames`.
void FramesStudy::measure_tasks(const std::vector<FrameTask>& tasks, const Scene& scene,
                                const std::vector<View>& views) {
  const bool moves = tasks.front().work == "loop";
  std::vector<uint64_t> turns(tasks.size());
  std::vector<Contender> contenders;
  for (size_t i = 0; i < tasks.size(); ++i) {
    const FrameTask& task = tasks[i];
    const auto draw = [&task, &views, &turn = turns[i]](Backend& backend) {
      drawing_of(backend).enqueue_draw(views[turn++ % views.size()], draw_options(task));
    };
    Contender& contender = contenders.emplace_back(
        Contender{.label = label(task),
                  .backend = task.backend,
                  .step = draw,
                  .contest = fmt::format("{} {} {}", draw_method_name(task.draw), task.place, task.work)});
    if (!moves) continue;
    contender.step = [draw, n = scene.size()](Backend& backend) {
      backend.move();
      backend.enqueue_collide(in_dense_cells(backend, n));
      draw(backend);
    };
    contender.restart = [&turn = turns[i], start = start_of_loop(scene)](Backend& backend) {
      turn = 0;
      start(backend);
    };
    contender.batch = steps_of_loop;
    contender.prepares = true;  // cells that falling spheres leave are planned anew
  }
  progress_.say(fmt::format("{}, {}", counted(scene.size(), "sphere"), contenders.front().contest));
  const std::vector<Samples> samples = measure(session_, contenders, sampling_, progress_);
  for (size_t i = 0; i < tasks.size(); ++i) {
    frames[frames.size() - tasks.size() + i].update(to_json(samples[i]));
    if (moves) start_of_loop(scene)(*tasks[i].backend);  // restores the positions
  }
  progress_.clear();
}

// Begins the task's entry. The images of the exact methods must be equal on all backends, with and without culling. The
// statistics are those of the third image from one camera, when all culling is active; the image compared is the second
// of two drawn with the timed options.
void FramesStudy::check(uint64_t n, const FrameTask& task, const std::vector<View>& views) {
  json entry = {{"n", n},
                {"backend", task.backend->info().name},
                {"draw", draw_method_name(task.draw)},
                {"place", task.place},
                {"work", task.work}};
  const bool exact = task.draw == DrawMethod::compute;
  Drawing& drawing = drawing_of(*task.backend);
  for (int time = 0; exact && time < 3; ++time) drawing.draw(views.front(), draw_options(task, true));
  if (exact && !task.backend->info().on_host) entry["counts"] = to_json(drawing.draw_statistics());
  for (int time = 0; time < 2; ++time) drawing.draw(views.front(), draw_options(task));
  const json image = entry["image"] = hex64(image_hash(drawing.image()));
  for (const json& other : frames)
    if (other.at("n") == n && other.at("place") == task.place && other.at("draw") == "compute" && exact &&
        (other.at("work") == "lit") == (task.work == "lit") && other.at("image") != image)
      throw DifferenceFound(fmt::format("{}: the image differs from that of {} {}", label(task),
                                        other.at("backend").get<std::string>(), other.at("work").get<std::string>()),
                            entry);
  frames.push_back(std::move(entry));
}

}  // namespace spherepair
