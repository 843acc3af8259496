// SPDX-License-Identifier: MIT
#include "bench/studies/crossover_sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/io/scene_text.h"
#include "bench/measure/choice.h"
#include "bench/measure/floors.h"
#include "bench/studies/study_sampling.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

constexpr double tolerated = 1.1;  // auto's time over the best fixed choice's
constexpr double hopeless = 8;     // a method of all pairs that takes this many times the best time is stopped ...
constexpr double long_ms = 0.25;   // ... if its step takes longer than this, so that launches do not dominate
constexpr SphereKind kinds[] = {{"gas", "packing fraction 0.3", "uniform"},
                                {"thin", "packing fraction 0.05", "uniform", 0.05},
                                {"box", "the paper's box of constant size", "random"},
                                {"clusters", "dense clusters far apart", "clustered"},
                                {"radii", "radii 1 to 16, packing fraction of the smallest 0.01", "uniform", 0.01, 16},
                                {"one_cell", "all spheres in one cell", "one_cell"}};

SceneOptions scene_of(const SphereKind& kind, uint64_t n) {
  SceneOptions scene;
  scene.name = kind.scene;
  scene.n = n;
  scene.packing_fraction = kind.packing_fraction;
  scene.radius_ratio = kind.radius_ratio;
  return scene;
}

// Options of a step that sorts, as after a move.
CollideOptions step(Method method, Cells cells = Cells::automatic, uint block = CollideOptions{}.block) {
  return {.method = method, .block = block, .grid = {.cells = cells, .keep_order = false, .keep_cells = false}};
}

std::string way_name(Method method, Cells cells, uint block) {
  if (method == Method::collide_grid) return cells == Cells::dense ? "dense" : "hashed";
  return method == Method::collide_square ? square_way(block) : method_name(method);
}

// The fixed choices first, auto last.
std::vector<Way> ways_of(Backend& backend) {
  std::vector<Way> ways;
  const bool cpu = backend.info().on_host;
  for (const uint block : square_groups)
    if (!cpu) ways.push_back({&backend, square_way(block), false, step(Method::collide_square, {}, block)});
  const Method other = cpu ? Method::parallel : Method::collide_triangle;
  ways.push_back({&backend, method_name(other), false, step(other)});
  ways.push_back({&backend, "dense", true, step(Method::collide_grid, Cells::dense)});
  ways.push_back({&backend, "hashed", true, step(Method::collide_grid, Cells::hashed)});
  ways.push_back({&backend, "auto", false, step(Method::automatic)});
  return ways;
}

double least(const std::map<std::string, double>& seconds) {
  double found = INFINITY;
  for (const auto& [way, time] : seconds) found = std::min(found, time);
  return found;
}

}  // namespace

std::string square_way(uint block) { return fmt::format("{}/{}", method_name(Method::collide_square), block); }

std::span<const SphereKind> sphere_kinds() { return kinds; }

Loss loss_of(const Timing& timing) {
  if (timing.best.empty()) return Loss::within;
  const Contest& auto_to_best = timing.over_best;
  if (!enough_rounds(auto_to_best) || !auto_to_best.steady) return Loss::undecided;
  if (auto_to_best.ratios.high <= tolerated) return Loss::within;
  return auto_to_best.ratios.low > tolerated ? Loss::beyond : Loss::undecided;
}

json to_json(const Timing& t) {
  json row = {
      {"backend", t.backend}, {"kind", t.kind}, {"n", t.n}, {"chosen", t.chosen}, {"auto_ms", t.automatic * 1e3}};
  if (t.best.empty()) return row;
  row["best"] = t.best;
  row["best_ms"] = std::min(least(t.all_pairs), least(t.grid)) * 1e3;
  row["loss_percent"] = (t.over_best.ratio - 1) * 100;
  row["loss_interval_percent"] = {(t.over_best.ratios.low - 1) * 100, (t.over_best.ratios.high - 1) * 100};
  row["coverage"] = t.over_best.ratios.coverage;
  constexpr const char* losses[] = {"within 1.1x", "beyond 1.1x", "not decided"};
  row["loss"] = losses[size_t(loss_of(t))];
  return row;
}

CrossoverSweep::CrossoverSweep(Session& session, const CrossoverOptions& options, std::function<void()> write)
    : session_(session), options_(options), write_(std::move(write)) {
  sampling_ = study_sampling(options.rounds);
  sampling_.software_seconds = 0.003;
  sampling_.hardware_seconds = 0.015;
  sampling_.longest = 0.02;
}

void CrossoverSweep::run(std::span<const SphereKind> chosen, const std::vector<uint64_t>& sizes) {
  uint64_t done = 0;
  for (const SphereKind& kind : chosen) {
    slow_.clear();
    for (const uint64_t n : sizes) {
      progress_.reach(done++, chosen.size() * sizes.size());
      measure_scene(kind, scene_of(kind, n));
      write_();
    }
  }
}

void CrossoverSweep::measure_scene(const SphereKind& kind, const SceneOptions& options) {
  progress_.say(fmt::format("checking {} of {}", kind.name, options.n));
  const Scene scene = make_scene(options);
  for (const auto& backend : session_.backends()) backend->upload(scene);
  const StepResult expected = run_step(session_, reference_for(session_, {}, options.n), false);
  for (const auto& backend : session_.backends()) {
    if (slow_.contains(backend->info().name + " auto")) continue;
    std::vector<Way> ways = ways_of(*backend);
    std::erase_if(ways, [&](const Way& w) { return slow_.contains(backend->info().name + " " + w.name); });
    session_.comparisons.plan(backend->info().name, Comparisons::sets, ways.size());
    check(options, expected, ways);
    session_.comparisons.require_complete();
    time(kind, options, ways);
  }
}

void CrossoverSweep::check(const SceneOptions& options, const StepResult& expected, const std::vector<Way>& ways) {
  const Configuration reference = reference_for(session_, {}, options.n);
  for (const Way& way : ways) {
    const Configuration configuration{way.backend, way.options};
    require_equal(session_, {options, 0}, reference, expected, configuration, run_step(session_, configuration, false));
  }
}

void CrossoverSweep::time(const SphereKind& kind, const SceneOptions& scene, const std::vector<Way>& ways) {
  std::vector<Contender> contenders;
  for (const Way& w : ways) {
    const std::string label = fmt::format("{} {} {} of {}", w.backend->info().name, w.name, kind.name, scene.n);
    contenders.push_back({.label = label,
                          .backend = w.backend,
                          .step = [o = w.options](Search& search) { search.enqueue_collide(o); },
                          .contest = "ways",
                          .alternates = true,
                          .working_set = search_set_bytes(scene.n, w.options.method, false)});
  }
  const std::vector<Samples> samples = measure(session_, contenders, sampling_, progress_);
  Timing timing{.backend = ways.front().backend->info().name, .kind = kind.name, .n = scene.n};
  compare(timing, ways, samples);
  for (size_t k = 0; k < ways.size(); ++k) record(kind, scene, ways[k], samples[k]);
  timings.push_back(timing);
  const double fastest = std::min({least(timing.all_pairs), least(timing.grid), timing.automatic});
  for (size_t k = 0; k < ways.size(); ++k) stop_if_slow(ways[k], timing, minimum(samples[k].seconds), fastest);
}

void CrossoverSweep::compare(Timing& timing, const std::vector<Way>& ways, const std::vector<Samples>& samples) {
  const Samples* best = nullptr;
  for (size_t k = 0; k + 1 < ways.size(); ++k) {
    (ways[k].grid ? timing.grid : timing.all_pairs)[ways[k].name] = samples[k].median_seconds();
    if (best && samples[k].median_seconds() >= best->median_seconds()) continue;
    best = &samples[k];
    timing.best = ways[k].name;
  }
  timing.automatic = samples.back().median_seconds();
  for (size_t k = 0; k < ways.size(); ++k)
    if (!samples[k].unsteady().empty()) timing.unsteady.insert(ways[k].name);
  const MethodChoice choice = ways.back().backend->choice(ways.back().options);
  timing.chosen = way_name(choice.method, choice.cells, choice.block);
  if (best) timing.over_best = contest(samples.back(), *best);
}

// The time of all pairs quadruples when n doubles, so a method that is far behind stays behind. `seconds` is the
// minimum of the samples, which disturbances do not affect.
void CrossoverSweep::stop_if_slow(const Way& way, const Timing& at, double seconds, double fastest) {
  const double ms = seconds * 1e3;
  const bool too_long = ms > options_.most_ms, behind = seconds > hopeless * fastest && ms > long_ms;
  if (!too_long && !(behind && at.all_pairs.contains(way.name))) return;
  slow_.insert(at.backend + " " + way.name);
  stopped.push_back(fmt::format("{} {} {}: stopped after {}, {} ms per step is more than {}", at.backend, at.kind,
                                way.name, counted(at.n, "sphere"), format_ms(seconds),
                                too_long ? "--most-ms" : fmt::format("{} times the best time", hopeless)));
}

void CrossoverSweep::record(const SphereKind& kind, const SceneOptions& scene, const Way& way, const Samples& samples) {
  json row = {{"table", "crossover"}, {"n", scene.n},    {"scene", scene_json(scene)},
              {"kind", kind.name},    {"way", way.name}, {"choice", to_json(way.backend->choice(way.options))}};
  row.update(to_json(samples));
  measurements.push_back(std::move(row));
}

}  // namespace spherepair
