// SPDX-License-Identifier: MIT
// spherepair sets
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "bench/cli/studies.h"
#include "bench/cli/study_run.h"
#include "bench/io/arguments.h"
#include "bench/io/motion_choice.h"
#include "bench/options/options.h"
#include "bench/studies/set_errors.h"
#include "bench/studies/study_sampling.h"

namespace spherepair {
namespace {

SetPlan make_set_plan(const SetsOptions& options, bool hardware) {
  SetPlan plan;
  plan.motions = chosen_motions(options.methods, options.precisions);
  plan.steps = options.quick ? std::vector{4, 6}
               : hardware    ? std::vector{4, 6, 8, 10, 12, 14}
                             : std::vector{4, 6, 8, 10};
  plan.offsets = {1e2f, 1e3f, 1e4f, 1e5f, 1e6f, 1e7f};
  plan.sampling = study_sampling();
  if (options.quick) plan.sampling.rounds = fewest_for_interval;
  if (hardware) {
    plan.n = 1 << 16;
    plan.naive_n = 1 << 20;
  }
  if (!options.quick) return plan;
  plan.seconds = 2;
  plan.n = plan.naive_n = 2048;
  plan.passing = 600;
  plan.offsets = {1e3f, 1e6f};
  plan.distances = {0.5, 1.0, 5.0};
  plan.sampling.software_seconds = 0.005;
  return plan;
}

std::string share(uint64_t wrong, const SetError& error) {
  const double percent = 100 * double(wrong) / double(std::max<uint64_t>(error.right, 1));
  return percent < 100 ? fmt::format("{} ({:.2g} %)", wrong, percent) : fmt::format("{} ({:.0f} %)", wrong, percent);
}

Table motion_table(const SetPlan& plan, const std::vector<MotionSetEntry>& entries) {
  Table table{fmt::format("Wrong pairs (missed + extra) after {} s against the closed form", plan.seconds),
              {{"", "method", "", true},
               {"", "precision", "", true},
               {"", "dt", "s"},
               {"", "offset", "m"},
               {"positions in precision", "float32", "pairs"},
               {"positions in precision", "full", "pairs"},
               {"", "rms error", "m"}},
              {},
              {"In brackets: the share of the right pairs. full: all bits that the motion's precision keeps."}};
  for (const MotionSetEntry& entry : entries)
    table.rows.push_back(
        {motion_name(entry.motion.method), precision_name(entry.motion.precision), fmt::format("2^-{}", entry.k),
         fmt::format("{:g}", entry.offset), share(entry.found.missed + entry.found.extra, entry.found),
         share(entry.whole.missed + entry.whole.extra, entry.found), fmt::format("{:.1e}", entry.rms)});
  return table;
}

Table storage_table(const std::vector<StorageEntry>& entries) {
  Table table{
      "Wrong pairs from storing positions away from the origin, without motion",
      {{"", "precision", "", true}, {"", "offset", "m"}, {"", "right", "pairs"}, {"", "missed", ""}, {"", "extra", ""}},
      {},
      {}};
  for (const StorageEntry& entry : entries)
    table.rows.push_back({precision_name(entry.precision), fmt::format("{:g}", entry.offset),
                          std::to_string(entry.error.right), share(entry.error.missed, entry.error),
                          share(entry.error.extra, entry.error)});
  return table;
}

Table naive_table(const std::vector<NaiveEntry>& entries) {
  Table table{"Pairs that the naive predicate gets wrong, and the time of the exact one",
              {{"", "scene", "", true},
               {"", "spheres", ""},
               {"", "backend, method", "", true},
               {"naive", "right", "pairs"},
               {"naive", "missed", ""},
               {"naive", "extra", ""},
               {"naive", "time", "ms"},
               {"exact", "time", "ms"},
               {"exact", "time/naive", "", true}},
              {},
              {}};
  for (const NaiveEntry& entry : entries)
    table.rows.push_back({entry.scene, std::to_string(entry.n), entry.exact.backend + " " + entry.method,
                          std::to_string(entry.error.right), std::to_string(entry.error.missed),
                          std::to_string(entry.error.extra), time_cell(entry.naive), time_cell(entry.exact),
                          ratio_text(contest(entry.exact, entry.naive))});
  return table;
}

Table contact_table(const std::vector<ContactEntry>& entries) {
  Table table{"Contacts missed between steps, of pairs that pass through each other",
              {{"", "distance/step", "radius sums"},
               {"", "backend", "", true},
               {"", "pairs", ""},
               {"tested once per step", "missed", ""},
               {"tested once per step", "expected", ""},
               {"tested once per step", "deviation", "sigma"},
               {"swept", "missed", ""}},
              {},
              {}};
  for (const ContactEntry& entry : entries)
    table.rows.push_back({fmt::format("{:g}", entry.distance), entry.backend, std::to_string(entry.pairs),
                          std::to_string(entry.missed), fmt::format("{:.1f}", entry.expected()),
                          fmt::format("{:+.1f}", (double(entry.missed) - entry.expected()) / entry.deviation()),
                          std::to_string(entry.swept_missed)});
  return table;
}

}  // namespace

int sets_command(const CommandLine& line, const SetsOptions& options) {
  make_set_plan(options, false);  // throws for bad values before any work
  StudyRun run(line, "sets", options.results, options.backends);
  Session& session = run.session();
  const SetPlan plan = make_set_plan(options, run.hardware());
  Progress progress;
  const auto motion = measure_motion_sets(session, plan, progress);
  const auto storage = measure_storage(plan, progress);
  const auto naive = measure_naive(session, plan, progress);
  const auto contacts = measure_contacts(session, plan, progress);
  progress.clear();
  const std::vector<Table> tables = {motion_table(plan, motion), storage_table(storage), naive_table(naive),
                                     contact_table(contacts)};
  run.record.update(
      {{"format", "spherepair sets 1"},
       {"settings", {{"n", plan.n}, {"seconds", plan.seconds}, {"seed", plan.seed}, {"restitution", 1}, {"speed", 1}}},
       {"motion", list_of(motion)},
       {"storage", list_of(storage)},
       {"exactness", list_of(naive)},
       {"contacts", list_of(contacts)}});
  return run.finish([&](size_t width) { return text_of(tables, width); }, list_of(naive));
}

std::shared_ptr<SetsOptions> add_sets_options(CLI::App& command) {
  auto options = std::make_shared<SetsOptions>();
  add_backends_option(command, options->backends);
  add_list(command, "--motions", options->methods, "Only these methods, e.g. paper,anchored (see run --help)");
  add_list(command, "--precisions", options->precisions, "Only these of float32, compensated, float64");
  command.add_flag("--quick", options->quick, "Few time steps, distances and spheres");
  add_results_option(command, options->results, "sets.json, .txt and .csv");
  command.footer("Example:\n  spherepair sets --quick --motions paper,impact,anchored");
  return options;
}

}  // namespace spherepair
