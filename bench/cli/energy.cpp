// SPDX-License-Identifier: MIT
// spherepair energy: energy.json has an entry of `measurements` for each work, size and backend:
//   n, scene, work, method, block, backend
//   power                        as the GPU reports it: instant, or the mean of a second
//   windows                      seconds, steps, counter_watts, integrated_watts of each
//   samples_ms, median_ms        the time of a step in each window
//   counter_watts, integrated_watts   medians; the same idle: idle_counter_watts, idle_integrated_watts
//   joules_per_step, nanojoules_per_sphere   by the counter, idle power subtracted; with it: joules_per_step_with_idle
//   joules_per_step_integrated, disagreement   the other method, and its ratio to the counter minus 1
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "bench/cli/studies.h"
#include "bench/cli/study_run.h"
#include "bench/io/arguments.h"
#include "bench/options/options.h"

namespace spherepair {
namespace {

std::string table_of(const json& measurements, size_t width) {
  Table table{
      "Energy of a step on the GPU, medians of the windows; idle power is subtracted",
      {{"", "work", "", true},
       {"", "n", ""},
       {"", "backend", "", true},
       {"power", "all", "W"},
       {"power", "idle", "W"},
       {"", "step", "ms"},
       {"energy", "of a step", "J"},
       {"energy", "a sphere", "nJ"},
       {"", "methods", "%"}},
      {},
      {"methods: the energy by the integrated power over that by the counter, less 1. Rows whose two methods are "
       "more than 3 % apart say nothing.",
       "A step is a search for pairs: all pairs by collide_triangle, warm and cold by the grid."}};
  for (const json& row : measurements) {
    const auto number = [&](const char* name, double factor = 1) {
      return format_number(factor * row.at(name).get<double>());
    };
    table.rows.push_back({row.at("work"), std::to_string(row.at("n").get<uint64_t>()), row.at("backend"),
                          number("counter_watts"), number("idle_counter_watts"), time_cell(row),
                          number("joules_per_step"), number("nanojoules_per_sphere"), number("disagreement", 100)});
  }
  return table.text(width) + "\n";
}

}  // namespace

int energy_command(const CommandLine& line, const EnergyOptions& options) {
  for (const std::string& work : options.works) require_known("work", work, energy_works());
  StudyRun run(line, "energy", options.results, options.backends);
  EnergyStudy study(run.session(), options, [&] {
    run.record["measurements"] = study.measurements;
    run.write();
  });
  study.run();
  return run.finish([&](size_t width) { return table_of(study.measurements, width); }, study.measurements);
}

std::shared_ptr<EnergyOptions> add_energy_options(CLI::App& command) {
  auto options = std::make_shared<EnergyOptions>();
  add_backends_option(command, options->backends);
  add_list(command, "--works", options->works,
           "Only these: all_pairs; warm, cold: the grid with spheres in cell order, in random order");
  add_list(command, "--n", options->sizes,
           "Numbers of spheres (default: of all pairs 16384, 1048576, of the grid 1000000, 10000000)")
      ->transform(positive_range);
  add_number(command, "--seconds", options->seconds, real_number(0.1, 3600),
             "Of each window; NVML's counters need 10 for 1 %");
  add_number(command, "--windows", options->windows, whole_number(1, 1000), "Windows of each row");
  add_results_option(command, options->results, "energy.json, .txt and .csv");
  command.footer("Needs an NVIDIA GPU and its driver's NVML.\nExample:\n  spherepair energy --backends opengl,cuda");
  return options;
}

}  // namespace spherepair
