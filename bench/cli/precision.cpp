// SPDX-License-Identifier: MIT
// spherepair precision
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "bench/cli/studies.h"
#include "bench/cli/study_run.h"
#include "bench/io/arguments.h"
#include "bench/io/motion_choice.h"
#include "bench/options/options.h"
#include "bench/studies/study_sampling.h"
#include "bench/studies/work_precision.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

PrecisionPlan make_precision_plan(const PrecisionOptions& options, bool hardware) {
  PrecisionPlan plan;
  plan.error_steps = options.quick ? std::vector{4, 6, 8} : std::vector{4, 5, 6, 8, 10, 12, 14};
  plan.time_steps = options.quick ? std::vector{6} : hardware ? std::vector{4, 5, 6, 8, 10} : std::vector{5, 6, 10};
  if (!options.steps.empty()) plan.error_steps = plan.time_steps = options.steps;
  plan.time_n = options.n ? options.n : hardware ? 1 << 22 : options.quick ? 1 << 14 : 1 << 16;
  plan.sampling = study_sampling(options.rounds);
  plan.sampling.ahead = 0;  // each batch begins with an upload, which takes longer than the batch, and has few launches
  if (!hardware) plan.sampling.software_seconds = 0.01;
  plan.motions = chosen_motions(options.methods, options.precisions);
  return plan;
}

// A row per method and precision, a column per time step; errors of the first backend that ran it.
Table error_table(const PrecisionPlan& plan, const std::vector<ErrorEntry>& errors) {
  Table table{fmt::format("Rms position error after {} s, metres", plan.seconds),
              {{"", "method", "", true}, {"", "precision", "", true}},
              {},
              {}};
  for (int k : plan.error_steps) table.columns.push_back({"dt", fmt::format("2^-{}", k), "s"});
  for (const MotionOptions& motion : plan.motions) {
    std::vector<std::string> row = {motion_name(motion.method), precision_name(motion.precision)};
    for (int k : plan.error_steps) {
      const auto found =
          std::ranges::find_if(errors, [&](const ErrorEntry& e) { return e.motion == motion && e.k == k; });
      row.push_back(found == errors.end() ? "-" : fmt::format("{:.1e}", found->rms));
    }
    table.rows.push_back(row);
  }
  table.notes.push_back(
      fmt::format("{} spheres of the scene random, restitution 1, against the closed form in "
                  "quadruple precision. Every backend that ran gave the same bits.",
                  plan.error_n));
  return table;
}

// A row per method, precision and work, a column per backend.
Table time_table(const PrecisionPlan& plan, const std::vector<TimeEntry>& times, int k) {
  std::vector<std::string> backends;
  for (const TimeEntry& entry : times)
    if (std::ranges::find(backends, entry.backend) == backends.end()) backends.push_back(entry.backend);
  const double bouncing = times.empty() ? 0 : std::ranges::find(times, k, &TimeEntry::k)->bouncing;
  Table table{fmt::format("Time of a step at dt = 2^-{} s, {}, of which {:.2f} % bounce", k,
                          counted(plan.time_n, "sphere"), 100 * bouncing),
              {{"", "method", "", true}, {"", "precision", "", true}, {"", "work", "", true}},
              {},
              {}};
  for (const std::string& backend : backends) table.columns.push_back({"median per sphere", backend, "ns"});
  for (const TimeEntry& first : times) {
    if (first.k != k || first.backend != backends.front()) continue;
    std::vector<std::string> row = {motion_name(first.motion.method), precision_name(first.motion.precision),
                                    first.work};
    for (const std::string& backend : backends)
      for (const TimeEntry& entry : times)
        if (entry.k == k && entry.backend == backend && entry.motion == first.motion && entry.work == first.work)
          row.push_back(time_cell(entry.samples, 1e9 / double(entry.n)));
    table.rows.push_back(row);
  }
  return table;
}

struct Measured {
  std::vector<ErrorEntry> errors;
  std::vector<TimeEntry> times;
  std::vector<CopyEntry> copies;
};

std::string tables_of(const PrecisionPlan& plan, const Measured& measured, size_t width) {
  std::string text = error_table(plan, measured.errors).text(width);
  for (int k : plan.time_steps) text += "\n" + time_table(plan, measured.times, k).text(width);
  for (const CopyEntry& copy : measured.copies)
    text += fmt::format("\nCopying the positions of {} on {}: {:.4g} GB/s read and written\n",
                        counted(copy.n, "sphere"), copy.backend, copy.bytes_per_second() / 1e9);
  return text;
}

}  // namespace

int precision_command(const CommandLine& line, const PrecisionOptions& options) {
  make_precision_plan(options, false);  // throws for bad values before any work
  StudyRun run(line, "precision", options.results, options.backends);
  const PrecisionPlan plan = make_precision_plan(options, run.hardware());
  Progress progress;
  const Measured measured = {measure_errors(run.session(), plan, progress),
                             measure_times(run.session(), plan, progress),
                             measure_copies(run.session(), plan, progress)};
  progress.clear();
  run.record.update({{"format", "spherepair precision 1"},
                     {"settings",
                      {{"seconds", plan.seconds},
                       {"error_n", plan.error_n},
                       {"time_n", plan.time_n},
                       {"seed", plan.seed},
                       {"restitution", 1}}},
                     {"errors", list_of(measured.errors)},
                     {"times", list_of(measured.times)},
                     {"copies", list_of(measured.copies)}});
  return run.finish([&](size_t width) { return tables_of(plan, measured, width); },
                    {{"times", run.record["times"]}, {"copies", run.record["copies"]}});
}

std::shared_ptr<PrecisionOptions> add_precision_options(CLI::App& command) {
  auto options = std::make_shared<PrecisionOptions>();
  add_backends_option(command, options->backends);
  add_list(command, "--motions", options->methods, "Only these methods, e.g. paper,anchored (see run --help)");
  add_list(command, "--precisions", options->precisions, "Only these of float32, compensated, float64");
  command.add_option("--n", options->n, "Spheres of the timings (default 4194304 on a GPU, else 65536)")
      ->transform(positive_range);
  add_list(command, "--steps", options->steps, "Only these time steps: k of dt = 2^-k s, e.g. 4,6,10")
      ->transform(whole_number(0, 20));
  add_rounds_option(command, options->rounds, 6);
  command.add_flag("--quick", options->quick, "Few time steps and spheres");
  add_results_option(command, options->results, "precision.json, .txt and .csv");
  command.footer("Example:\n  spherepair precision --quick --motions paper,impact,anchored");
  return options;
}

}  // namespace spherepair
