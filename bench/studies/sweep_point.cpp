// SPDX-License-Identifier: MIT
#include "bench/studies/sweep_point.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "bench/io/scene_text.h"
#include "bench/studies/frames.h"
#include "common/backend/method_choice.h"

namespace spherepair {
namespace {

// Options with which every step does all the work and keeps nothing from the previous step.
Configuration configuration_for(Backend& backend, Method method, const SweepPoint& point) {
  const CollideOptions automatic = {.method = Method::automatic};
  const uint block = point.block ? point.block : chosen_block(backend.info(), point.n, method, automatic);
  return {&backend, {.method = method, .block = block, .grid = {.keep_cells = false}}};
}

bool is_device_arrangement(Method method) {
  return method == Method::collide_tiled || method == Method::collide_square || method == Method::collide_triangle;
}

json left_out(const Backend& backend, const std::string& methods, const std::string& reason) {
  return {{"backend", backend.info().name}, {"method", methods}, {"reason", reason}};
}

// The requested methods that are fast enough. Cell order matters to the grid only, so all pairs are timed cold only.
std::vector<Configuration> affordable(Backend& backend, const SweepPoint& point, json& omitted) {
  std::vector<Configuration> all;
  for (const Method method : backend.methods()) {
    if (std::ranges::find(point.methods, method) == point.methods.end()) continue;
    if (point.in_cell_order && method != Method::collide_grid) continue;
    if (backend.info().on_host && is_device_arrangement(method)) continue;
    if (point.n <= most_spheres(backend, method)) {
      all.push_back(configuration_for(backend, method, point));
    } else {
      omitted.push_back(left_out(backend, method_name(method), "a step would take too long"));
    }
  }
  return all;
}

// Uploads the scene to every backend that has a method to time; leaves out a backend that cannot hold it.
std::vector<Configuration> prepare(Session& session, const SweepPoint& point, const Scene& scene, json& omitted) {
  std::vector<Configuration> all;
  for (const auto& backend : session.backends()) {
    const std::vector<Configuration> own = affordable(*backend, point, omitted);
    if (own.empty()) continue;
    try {
      backend->upload(scene);
      all.insert(all.end(), own.begin(), own.end());
    } catch (const BackendError& error) {
      omitted.push_back(left_out(*backend, "all", error.what()));
    }
  }
  return all;
}

// The first configuration that finds this set: the CPU's if the CPU is among the backends.
const Configuration& reference_of(const std::vector<Configuration>& all, const Configuration& configuration) {
  return *std::ranges::find_if(
      all, [&](const Configuration& one) { return set_name(one.options) == set_name(configuration.options); });
}

json row_of(Session& session, const SweepPoint& point, const Configuration& configuration,
            const Configuration& reference, const Collisions& totals, const PeakRates& peak_rates,
            const Samples& samples) {
  const Method method = configuration.options.method;
  json row = {{"table", "grid"},
              {"work", "collide"},
              {"n", point.n},
              {"scene", scene_json(scene_of(point))},
              {"order", point.in_cell_order ? "warm" : "cold"},
              {"method", method_name(method)},
              {"block", uses_blocks(configuration) ? json(configuration.options.block) : json(nullptr)},
              {"first_step_ms", session.first_seconds(*configuration.backend, configuration.options) * 1e3},
              {"checked_against", label(reference)},
              {"pairs", totals.pairs},
              {"colliding_spheres", totals.colliding_spheres},
              {"fingerprint", hex64(totals.fingerprint.a) + hex64(totals.fingerprint.b)}};
  row.update(to_json(samples));
  if (const auto floor = floor_of(peak_rates, *configuration.backend, method, point.n, point.in_cell_order)) {
    row["floor"] = floor->what;
    row["peak_per_second"] = floor->per_second;
    row["floor_ms"] = floor->seconds * 1e3;
    row["share_of_floor"] = floor->seconds / samples.median_seconds();
  }
  return row;
}

}  // namespace

SceneOptions scene_of(const SweepPoint& point) {
  SceneOptions scene{.name = "uniform", .n = point.n, .seed = point.seed};
  scene.packing_fraction = point.packing_fraction;
  return scene;
}

std::string label(const SweepPoint& point) {
  return fmt::format("packing fraction {}, n = {}, {}", point.packing_fraction, point.n,
                     point.in_cell_order ? "warm" : "cold");
}

uint64_t most_spheres(const Backend& backend, Method method) {
  const bool gpu = on_hardware(backend), cpu = backend.info().on_host;
  switch (method) {
    case Method::sequential:
      return uint64_t(1) << 14;
    case Method::parallel:
      return uint64_t(1) << 16;
    case Method::collide_group:
      return uint64_t(1) << (gpu || cpu ? 20 : 16);
    case Method::collide_triangle:
    case Method::collide_tensor:
      return gpu ? uint64_t(1) << 20 : uint64_t(1) << 14;
    case Method::collide_grid:
      return gpu ? std::numeric_limits<uint64_t>::max() : cpu ? 10'000'000 : uint64_t(1) << 18;
    default:
      return uint64_t(1) << (gpu ? 17 : 12);
  }
}

PointTimes time_point(Session& session, const SweepPoint& point, const PeakRates& peak_rates, const Sampling& sampling,
                      Progress& progress) {
  PointTimes times;
  progress.say("checking " + label(point));
  Scene scene = make_scene(scene_of(point));
  if (point.in_cell_order) scene = in_cell_order(scene);
  const std::vector<Configuration> all = prepare(session, point, scene, times.left_out);
  scene = {};
  for (const Configuration& configuration : all)
    session.comparisons.plan(configuration.backend->info().name, Comparisons::sets, 1);
  std::map<std::string, StepResult> expected;
  std::vector<Contender> contenders;
  std::vector<Collisions> totals;
  for (const Configuration& configuration : all) {
    const Configuration& reference = reference_of(all, configuration);
    StepResult result = run_step(session, configuration, false);
    const StepResult& right = expected.try_emplace(set_name(configuration.options), result).first->second;
    require_equal(session, {scene_of(point), 0}, reference, right, configuration, result);
    totals.push_back(result.totals);
    contenders.push_back(
        {.label = label(configuration),
         .backend = configuration.backend,
         .step = [options = configuration.options](Search& search) { search.enqueue_collide(options); },
         .contest = method_name(configuration.options.method),  // each API with its own group size
         .working_set = search_set_bytes(point.n, configuration.options.method, point.in_cell_order)});
  }
  expected.clear();
  session.comparisons.require_complete();
  const std::vector<Samples> samples = measure(session, contenders, sampling, progress);
  for (size_t k = 0; k < all.size(); ++k)
    times.measurements.push_back(
        row_of(session, point, all[k], reference_of(all, all[k]), totals[k], peak_rates, samples[k]));
  return times;
}

}  // namespace spherepair
