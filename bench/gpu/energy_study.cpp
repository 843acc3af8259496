// SPDX-License-Identifier: MIT
#include "bench/gpu/energy_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <thread>

#include "bench/io/scene_text.h"
#include "bench/studies/frames.h"
#include "common/backend/method_choice.h"

namespace spherepair {
namespace {

constexpr double chunk_seconds = 0.05;  // steps between two waits last this long
constexpr uint64_t steps_probed = 20;   // to find how many steps that is
constexpr uint64_t seed = 1;            // of the random order

std::vector<uint64_t> sizes_of(const std::string& work, const EnergyOptions& options) {
  if (!options.sizes.empty()) return options.sizes;
  return work == "all_pairs" ? std::vector<uint64_t>{16384, 1 << 20} : std::vector<uint64_t>{1'000'000, 10'000'000};
}

SceneOptions scene_options(uint64_t n) {
  SceneOptions options;
  options.name = "uniform";
  options.n = n;
  return options;
}

Scene scene_of(const std::string& work, uint64_t n) {
  Scene scene = make_scene(scene_options(n));
  return work == "warm" ? in_cell_order(std::move(scene)) : scene;
}

Configuration configuration_of(const std::string& work, uint64_t n, Backend& backend) {
  const Method method = work == "all_pairs" ? Method::collide_triangle : Method::collide_grid;
  const uint block = chosen_block(backend.info(), n, method, {.method = Method::automatic});
  return {&backend, {.method = method, .block = block, .grid = {.keep_order = work == "warm", .keep_cells = false}}};
}

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string label_of(const std::string& work, uint64_t n, const Configuration& configuration) {
  return fmt::format("{} {} of {}", configuration.backend->info().name, work, n);
}

}  // namespace

const std::vector<std::string>& energy_works() {
  static const std::vector<std::string> works = {"all_pairs", "warm", "cold"};
  return works;
}

EnergyStudy::EnergyStudy(Session& session, const EnergyOptions& options, std::function<void()> write,
                         const std::string& library)
    : session_(session), options_(options), write_(std::move(write)) {
  for (const Backend* device : session.devices()) {
    const std::string uuid = device->info().uuid;
    if (!on_hardware(*device) || uuid.empty())
      throw BackendError(fmt::format("{} on {} has no energy counter: name backends of a GPU with --backends",
                                     device->info().name, device->info().device));
    meters_.try_emplace(uuid, uuid, library);
  }
  if (meters_.empty())
    throw BackendError("the energy of a GPU is measured, and none of opengl, cuda and vulkan is open");
}

const Scene& EnergyStudy::scene(const Row& row) {
  const auto key = std::pair(row.work, row.n);
  const auto found = scenes_.find(key);
  return found != scenes_.end() ? found->second : scenes_[key] = scene_of(row.work, row.n);
}

std::vector<EnergyStudy::Row> EnergyStudy::all_rows() const {
  std::vector<Row> rows;
  for (const std::string& work : options_.works)
    for (const uint64_t n : sizes_of(work, options_))
      for (Backend* device : session_.devices()) rows.push_back({work, n, configuration_of(work, n, *device)});
  return rows;
}

// In each round every row has a window, in random order: the GPU's temperature changes its power.
void EnergyStudy::run() {
  std::vector<Row> rows = all_rows();
  check(rows);
  measure_idle();
  std::vector<size_t> order(rows.size());
  std::iota(order.begin(), order.end(), 0);
  uint64_t state = seed, done = 0;
  for (int round = 0; round < options_.windows; ++round) {
    shuffle(order, state);
    for (const size_t k : order) {
      progress_.reach(done++, rows.size() * uint64_t(options_.windows));
      measure(rows[k]);
      measurements = json::array();
      for (const Row& row : rows)
        if (!row.windows.empty()) measurements.push_back(to_json(row));
      write_();
    }
  }
}

void EnergyStudy::check(const std::vector<Row>& rows) {
  for (const Row& row : rows) {
    progress_.say("checking " + label_of(row.work, row.n, row.configuration));
    const Configuration reference = reference_for(session_, {}, row.n);
    const SceneOptions options = scene_options(row.n);
    reference.backend->upload(scene(row));
    const StepResult expected = run_step(session_, reference, false);
    Backend& backend = *row.configuration.backend;
    if (&backend != reference.backend) backend.upload(scene(row));
    session_.comparisons.plan(backend.info().name, Comparisons::sets, 1);
    require_equal(session_, {options, 0}, reference, expected, row.configuration,
                  run_step(session_, row.configuration, false));
  }
  session_.comparisons.require_complete();
}

// Measures idle power after the check, with the backends open: half a window for the power to fall, then one window.
void EnergyStudy::measure_idle() {
  const auto rest = [] {
    std::this_thread::sleep_for(std::chrono::duration<double>(chunk_seconds));
    return uint64_t(0);
  };
  for (const auto& [uuid, meter] : meters_) {
    progress_.say("measuring the idle GPU");
    idle_[uuid] = measure_window(meter, options_.seconds, 0.5 * options_.seconds, rest).power;
  }
}

void EnergyStudy::measure(Row& row) {
  progress_.say("measuring " + label_of(row.work, row.n, row.configuration));
  Backend& backend = *row.configuration.backend;
  backend.upload(scene(row));
  const auto run = [&](uint64_t steps) {
    for (uint64_t k = 0; k < steps; ++k) backend.enqueue_collide(row.configuration.options);
    backend.finish();
  };
  run(steps_probed);
  const double step = seconds_of([&] { run(steps_probed); }) / double(steps_probed);
  const auto chunk = uint64_t(std::max(1.0, std::ceil(chunk_seconds / step)));
  const auto work = [&] { return run(chunk), chunk; };
  const Clocks clocks = host_clocks();
  const OtherPrograms others(clocks);
  row.windows.push_back(measure_window(meters_.at(uuid_of(row)), options_.seconds, 0.1 * options_.seconds, work));
  row.others = std::max(row.others, others.share());
}

json EnergyStudy::to_json(const Row& row) const {
  const MeanPower& idle = idle_.at(uuid_of(row));
  const auto median_of = [&](const auto& value) {
    std::vector<double> values;
    for (const EnergyWindow& window : row.windows) values.push_back(value(window));
    return median(values);
  };
  const auto joules = [&](double MeanPower::*method, double idle_watts) {
    return median_of([&](const EnergyWindow& w) { return (w.power.*method - idle_watts) * w.step_seconds(); });
  };
  const double counted = joules(&MeanPower::counter, idle.counter);
  const double integrated = joules(&MeanPower::integrated, idle.integrated);
  json samples = json::array(), windows = json::array();
  for (const EnergyWindow& window : row.windows) {
    samples.push_back(1e3 * window.step_seconds());
    windows.push_back({{"seconds", window.seconds},
                       {"steps", window.steps},
                       {"counter_watts", window.power.counter},
                       {"integrated_watts", window.power.integrated}});
  }
  const CollideOptions& options = row.configuration.options;
  json out = {{"table", "energy"},
              {"n", row.n},
              {"scene", scene_json(scene_options(row.n))},
              {"work", row.work},
              {"method", method_name(options.method)},
              {"block", options.block},
              {"backend", row.configuration.backend->info().name},
              {"label", label_of(row.work, row.n, row.configuration)},
              {"power", meters_.at(uuid_of(row)).instant() ? "instant" : "mean of a second"},
              {"samples_ms", samples},
              {"median_ms", 1e3 * median_of([](const EnergyWindow& w) { return w.step_seconds(); })},
              {"idle_counter_watts", idle.counter},
              {"idle_integrated_watts", idle.integrated},
              {"counter_watts", median_of([](const EnergyWindow& w) { return w.power.counter; })},
              {"integrated_watts", median_of([](const EnergyWindow& w) { return w.power.integrated; })},
              {"joules_per_step_with_idle", joules(&MeanPower::counter, 0)},
              {"joules_per_step", counted},
              {"joules_per_step_integrated", integrated},
              {"nanojoules_per_sphere", 1e9 * counted / double(row.n)},
              {"disagreement", integrated / counted - 1},
              {"windows", windows}};
  const auto reasons = unsteady(median_interval(samples.get<std::vector<double>>()), row.others);
  if (!reasons.empty()) out["unsteady"] = reasons;
  return out;
}

}  // namespace spherepair
