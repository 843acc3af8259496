// SPDX-License-Identifier: MIT
// Peak rates of each device through each API: the reference for every other time.
#include <fmt/format.h>

#include <algorithm>

#include <algorithm>

#include "bench/measure/floors.h"
#include "bench/tables/study.h"

namespace spherepair {
namespace {

struct PeakRateKind {
  PeakRate peak;
  const char *name, *unit;
  double per_sphere;  // of that unit
};
constexpr PeakRateKind kinds[] = {
    {PeakRate::copy, "copy", "GB/s", 2 * sizeof(vec4) / 1e9},  // read and written
    {PeakRate::atomics, "atomics", "10^9/s", 1 / 1e9},
    {PeakRate::issue, "multiply-adds", "10^12/s", double(PEAK_CHAINS) * PEAK_TURNS* PEAK_STEPS / 1e12}};

std::vector<std::string> peak_row(Study& study, const PeakRateKind& kind, const SceneOptions& scene) {
  std::vector<Contender> contenders;
  for (Backend* device : study.session.devices()) {
    study.progress.say(fmt::format("peak rates: checking {} on {}, n = {}", kind.name, device->info().name, scene.n));
    peak_rates_of(*device).check(kind.peak);
    contenders.push_back({.label = fmt::format("{} peak {}", device->info().name, kind.name),
                          .backend = device,
                          .step = [&kind](Backend& b) { peak_rates_of(b).launch(kind.peak); },
                          .contest = kind.name});
  }
  const double amount = kind.per_sphere * double(scene.n);
  const auto samples =
      study.time_unchecked("peak_rates", contenders,
                           {{"work", kind.name}, {"n", scene.n}, {"unit", kind.unit}, {"amount_per_step", amount}});
  std::vector<std::string> row = {kind.name, std::to_string(scene.n), kind.unit};
  for (const Samples& one : samples) {
    row.push_back(time_cell(one));
    row.push_back(format_number(amount / one.median_seconds()));
  }
  std::ranges::copy(study.compare("peak_rates", samples), std::back_inserter(row));
  return row;
}

}  // namespace

std::vector<Table> make_peak_rates(Study& study) {
  Table table{"Peak rates: copying, scattered atomic additions, multiply-adds in registers",
              {{"", "what", "", true}, {"", "spheres", ""}, {"", "unit", "", true}},
              {},
              {}};
  for (Backend* device : study.session.devices()) {
    const std::string group = device->info().name + (device->info().software ? " in SOFTWARE" : "");
    table.columns.push_back({group, "median", "ms"});
    table.columns.push_back({group, "rate", "units"});
  }
  if (study.session.devices().empty()) return {};
  add_contest_columns(table, study.session);
  // One size within and one beyond the caches of a GPU.
  const std::vector<uint64_t> sizes =
      study.plan.hardware ? std::vector<uint64_t>{1u << 20, 1u << 25} : std::vector<uint64_t>{1u << 16};
  for (uint64_t n : sizes) {
    SceneOptions scene = study.paper_scene(n);
    scene.name = "uniform";
    const Scene made = make_scene(scene);
    for (Backend* device : study.session.devices()) device->upload(made);
    for (const PeakRateKind& kind : kinds) table.rows.push_back(peak_row(study, kind, scene));
  }
  table.notes = {"copy: bytes read and written. The small size fits a GPU's cache, the large one does not."};
  return {table};
}

}  // namespace spherepair
