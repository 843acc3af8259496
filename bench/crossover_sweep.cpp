// SPDX-License-Identifier: MIT
#include "crossover_sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "answers.h"
#include "choice.h"

namespace spherepair {
namespace {

constexpr double tolerated = 1.1;  // auto against the best fixed choice
constexpr SphereKind kinds[] = {{"gas", "packing fraction 0.3", "uniform"},
                                {"thin", "packing fraction 0.05", "uniform", 0.05},
                                {"box", "the paper's box, fuller with every sphere", "random"},
                                {"clusters", "crowds far apart", "clustered"},
                                {"radii", "radii 1 to 16, packing fraction of the smallest 0.01", "uniform", 0.01, 16},
                                {"one_cell", "all spheres in one place", "one_cell"}};

SceneOptions scene_of(const SphereKind& kind, uint64_t n) {
  SceneOptions scene;
  scene.name = kind.scene;
  scene.n = n;
  scene.packing_fraction = kind.packing_fraction;
  scene.radius_ratio = kind.radius_ratio;
  return scene;
}

// Every step sorts anew, as one after spheres have moved does.
Way way(Backend& backend, const char* name, Method method, Cells cells = Cells::automatic) {
  return {&backend, name, {.method = method, .grid = {.cells = cells, .keep_order = false, .keep_cells = false}}};
}

std::vector<Way> ways_of(Backend& backend) {
  const bool cpu = backend.info().name == "cpu";
  return {way(backend, "all pairs", cpu ? Method::parallel : Method::collide_triangle),
          way(backend, "dense", Method::collide_grid, Cells::dense),
          way(backend, "hashed", Method::collide_grid, Cells::hashed), way(backend, "auto", Method::automatic)};
}

std::string took(const MethodChoice& choice) {
  const bool grid = choice.method == Method::collide_grid;
  return grid ? choice.cells == Cells::dense ? "grid, dense" : "grid, hashed" : "all pairs";
}

}  // namespace

std::span<const SphereKind> sphere_kinds() { return kinds; }

bool Timing::grid_ahead() const {
  const auto at = [&](const char* way) {
    const auto found = seconds.find(way);
    return found == seconds.end() ? INFINITY : found->second;
  };
  return std::min(at("dense"), at("hashed")) < at("all pairs");
}

CrossoverSweep::CrossoverSweep(Session& session, const CrossoverOptions& options)
    : session_(session), options_(options) {
  sampling_.rounds = options.rounds;
  sampling_.fewest_rounds = std::min(sampling_.fewest_rounds, options.rounds);
  sampling_.software_seconds = 0.01;
}

void CrossoverSweep::walk(const SphereKind& kind, const std::vector<uint64_t>& sizes) {
  slow_.clear();
  for (const uint64_t n : sizes) measure_scene(kind, scene_of(kind, n));
}

void CrossoverSweep::measure_scene(const SphereKind& kind, const SceneOptions& options) {
  const Scene scene = make_scene(options);
  for (const auto& backend : session_.backends()) {
    if (slow_.contains(backend->info().name + " auto")) continue;
    std::vector<Way> ways = ways_of(*backend);
    std::erase_if(ways, [&](const Way& w) { return slow_.contains(backend->info().name + " " + w.name); });
    backend->upload(scene);
    check(options, scene, ways);
    time(kind, options, ways);
  }
}

void CrossoverSweep::check(const SceneOptions& options, const Scene& scene, const std::vector<Way>& ways) {
  const Asked reference = reference_for(session_, {}, options.n);
  if (reference.backend != ways.front().backend) reference.backend->upload(scene);
  const Answer expected = ask(session_, reference, false);
  for (const Way& w : ways) {
    const Asked asked{w.backend, w.options};
    require_equal(session_, {options, 0}, reference, expected, asked, ask(session_, asked, false));
  }
}

void CrossoverSweep::time(const SphereKind& kind, const SceneOptions& scene, const std::vector<Way>& ways) {
  std::vector<Contender> contenders;
  for (const Way& w : ways) {
    const std::string label = fmt::format("{} {} {} of {}", w.backend->info().name, w.name, kind.name, scene.n);
    contenders.push_back({label, w.backend, [o = w.options](Backend& b) { b.collide(o); }, true});
  }
  const std::vector<Samples> samples = measure(contenders, sampling_, progress_);
  const Samples& automatic = samples.back();
  const Samples* best = nullptr;
  Timing timing{ways.front().backend->info().name, kind.name, scene.n, {}, {}, 0, false};
  timing.took = took(ways.back().backend->choice(ways.back().options));
  for (size_t k = 0; k < ways.size(); ++k) {
    const double seconds = timing.seconds[ways[k].name] = samples[k].median_seconds();
    if (k + 1 < ways.size() && (!best || seconds < best->median_seconds())) best = &samples[k];
    if (seconds * 1e3 > options_.most_ms) slow_.insert(timing.backend + " " + ways[k].name);
    record(kind, scene, ways[k], samples[k]);
  }
  timing.over_best = best ? automatic.median_seconds() / best->median_seconds() : 1;
  timing.slower = timing.over_best > tolerated && contest(*best, automatic).differ;
  timings.push_back(timing);
}

void CrossoverSweep::record(const SphereKind& kind, const SceneOptions& scene, const Way& way, const Samples& samples) {
  json row = {{"table", "crossover"}, {"n", scene.n},    {"scene", scene_json(scene)},
              {"kind", kind.name},    {"way", way.name}, {"choice", to_json(way.backend->choice(way.options))}};
  row.update(to_json(samples));
  measurements.push_back(std::move(row));
}

}  // namespace spherepair
