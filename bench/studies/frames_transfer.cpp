// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "api/exchange.h"
#include "bench/studies/frames_study.h"

namespace spherepair {
namespace {

// The share of the shorter time that is hidden: 1: completely; 0: no overlap. Noise may push it outside [0, 1].
json overlap_of(double frame, double step, double pipelined) {
  return {{"frame_ms", frame * 1e3},
          {"step_ms", step * 1e3},
          {"pipelined_ms", pipelined * 1e3},
          {"overlap", (frame + step - pipelined) / std::min(frame, step)}};
}

}  // namespace

json time_transfers(const TransferTask& task, const TimeStep& time) {
  json overlaps = json::array();
  Backend& backend = *task.backend;
  Drawing& drawing = drawing_of(backend);
  uint64_t turn = 0;
  const auto step = [&] {
    backend.move();
    backend.enqueue_collide(task.collide);
  };
  const double step_seconds = time("none", "step", step, true);
  for (const Transfer transfer : drawing.transfers()) {
    const std::string name = transfer_name(transfer);
    const auto transfer_and_draw = [&](DrawMethod method) {
      drawing.enqueue_draw(task.views[turn++ % task.views.size()],
                           {.method = method, .transfer = transfer, .reuse_unchanged = false});
    };
    time(
        "none", name, [&] { drawing.transfer(transfer), backend.finish(); }, false);
    for (const DrawMethod method : task.draws) {
      const std::string draw = draw_method_name(method);
      const double alone = time(
          draw, name, [&] { transfer_and_draw(method), backend.finish(); }, false);
      const double pipelined = time(
          draw, name + "_pipelined", [&] { transfer_and_draw(method), step(); }, true);
      backend.finish();
      json overlap = {{"backend", backend.info().name}, {"draw", draw}, {"transfer", name}};
      overlap.update(overlap_of(alone, step_seconds, pipelined));
      overlaps.push_back(overlap);
    }
  }
  return overlaps;
}

void FramesStudy::measure_transfers(uint64_t n, Backend& backend, const Scene& scene, const Bounds& bounds) {
  start_of_loop(scene)(backend);
  TransferTask task{&backend,
                    in_dense_cells(backend, n),
                    camera_path(bounds, "outside", options_.width, options_.height, contact_look()),
                    {}};
  for (const std::string& draw : options_.draws)
    if (draw != draw_method_name(DrawMethod::compute) && !beyond_most(n, draw))
      task.draws.push_back(draw_method_from_name(draw));
  const auto time = [&](const std::string& draw, const std::string& work, const std::function<void()>& step,
                        bool moves) {
    const json entry = {{"n", n},       {"to", "opengl"},
                        {"draw", draw}, {"place", "outside"},
                        {"work", work}, {"bytes", n * (sizeof(vec4) + sizeof(uint))}};
    return measure_transfer(entry, backend, step, moves ? &scene : nullptr);
  };
  for (json& overlap : time_transfers(task, time)) {
    overlap["n"] = n;
    overlaps.push_back(overlap);
  }
  backend.upload(make_scene({.n = 0}));  // frees its memory
}

void FramesStudy::measure_exchanges(uint64_t n, const Scene& scene) {
  Backend *cuda = session_.find("cuda"), *vulkan = session_.find("vulkan");
  if (!cuda || !vulkan) return;
  for (const auto& [from, to] : {std::pair{vulkan, cuda}, std::pair{cuda, vulkan}})
    for (const Transfer way : {Transfer::host, Transfer::imported}) try {
        for (Backend* each : {vulkan, cuda}) each->upload(scene);
        Exchange exchange(*from, *to, way);
        const json entry = {{"n", n},
                            {"to", to->info().name},
                            {"draw", "none"},
                            {"work", transfer_name(way)},
                            {"bytes", exchange.bytes()}};
        measure_transfer(
            entry, *from, [&] { exchange.run(); }, nullptr);
      } catch (const BackendError& error) {
        leave_out(n, *from, fmt::format("to {}, {}", to->info().name, transfer_name(way)), error.what());
      }
  for (Backend* each : {vulkan, cuda}) each->upload(make_scene({.n = 0}));  // frees their memory
}

// restart: the scene that each sample starts from; null: the step moves nothing. Returns seconds.
double FramesStudy::measure_transfer(json entry, Backend& backend, const std::function<void()>& step,
                                     const Scene* restart) {
  Contender contender{.label = fmt::format("{} to {} {} {}", backend.info().name, entry.at("to").get<std::string>(),
                                           entry.at("draw").get<std::string>(), entry.at("work").get<std::string>()),
                      .backend = &backend,
                      .step = [&](Backend&) { step(); }};
  if (restart) contender.restart = start_of_loop(*restart), contender.prepares = true;
  progress_.say(contender.label);
  const Samples samples = measure(session_, {&contender, 1}, sampling_, progress_).front();
  entry["transferred"] = true;
  entry.update(to_json(samples));
  frames.push_back(entry);
  progress_.clear();
  return samples.median_seconds();
}

}  // namespace spherepair
