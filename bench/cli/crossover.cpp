// SPDX-License-Identifier: MIT
#include "bench/cli/studies.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "bench/cli/study_run.h"
#include "bench/io/arguments.h"
#include "bench/options/options.h"
#include "bench/studies/crossover_sweep.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

std::string time_of(const Timing& t, const std::map<std::string, double>& seconds, const std::string& way) {
  const auto found = seconds.find(way);
  if (found == seconds.end()) return "-";
  return format_ms(found->second) + (t.unsteady.contains(way) ? unsteady_mark : "");
}

std::string over_best(const Timing& t) {
  if (t.best.empty() || !enough_rounds(t.over_best)) return "-";
  const std::string median = loss_of(t) == Loss::undecided ? "undecided" : fmt::format("{:.2f}x", t.over_best.ratio);
  return fmt::format("{} [{:.2f}, {:.2f}]", median, t.over_best.ratios.low, t.over_best.ratios.high);
}

// collide_square/32 becomes square/32.
std::string short_name(const std::string& way) {
  return way.starts_with("collide_") ? way.substr(way.find('_') + 1) : way;
}

Table table_of(const CrossoverSweep& sweep, const std::string& backend) {
  Table table{
      fmt::format("One collision step of all pairs, the grid and auto on {}; every step sorts the spheres", backend),
      {{"", "spheres", "", true},
       {"", "n", ""},
       {"all pairs", "parallel", "ms"},
       {"all pairs", "square/32", "ms"},
       {"all pairs", "/64", "ms"},
       {"all pairs", "/128", "ms"},
       {"all pairs", "triangle", "ms"},
       {"grid", "dense", "ms"},
       {"grid", "hashed", "ms"},
       {"auto", "median", "ms"},
       {"auto", "over best", "times", true},
       {"auto", "chose", "", true},
       {"auto", "best", "", true}},
      {},
      {}};
  for (const Timing& t : sweep.timings) {
    if (t.backend != backend) continue;
    std::vector<std::string> row = {t.kind, std::to_string(t.n), time_of(t, t.all_pairs, "parallel")};
    for (const uint block : square_groups) row.push_back(time_of(t, t.all_pairs, square_way(block)));
    row.insert(row.end(),
               {time_of(t, t.all_pairs, "collide_triangle"), time_of(t, t.grid, "dense"), time_of(t, t.grid, "hashed"),
                time_of(t, {{"auto", t.automatic}}, "auto"), over_best(t), short_name(t.chosen), short_name(t.best)});
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string tables_of(const CrossoverSweep& sweep, size_t width) {
  std::vector<std::string> backends;
  for (const Timing& t : sweep.timings)
    if (!std::ranges::count(backends, t.backend)) backends.push_back(t.backend);
  std::string text;
  for (const std::string& backend : backends) text += table_of(sweep, backend).text(width) + "\n";
  for (const std::string& note : sweep.stopped) text += wrapped(note, "* ", "  ", width) + "\n";
  return text;
}

// A line for each timing with this loss.
std::vector<std::string> rows_of(const std::vector<Timing>& timings, Loss loss) {
  std::vector<std::string> found;
  for (const Timing& t : timings) {
    if (loss_of(t) != loss) continue;
    found.push_back(fmt::format("{} {} {}: auto ({}) over {}: {}", t.backend, t.kind, t.n, t.chosen, t.best,
                                spread_text(t.over_best)));
  }
  return found;
}

std::string verdict(const std::vector<Timing>& timings, size_t width) {
  const auto within = std::ranges::count(timings, Loss::within, loss_of);
  std::string text = fmt::format("In {} of {} auto takes at most 1.1x the time of the best fixed choice\n", within,
                                 counted(timings.size(), "row"));
  const auto add = [&](Loss loss, const char* what) {
    const std::vector<std::string> rows = rows_of(timings, loss);
    if (!rows.empty()) text += wrapped(fmt::format("{} {}:", rows.size(), what), "", "", width) + "\n";
    for (const std::string& row : rows) text += wrapped(row, "  ", "    ", width) + "\n";
  };
  add(Loss::beyond, "WARNING: more than 1.1x");
  add(Loss::undecided, fmt::format("not decided by this data (more --rounds, at least {}, or a machine with less other "
                                   "load narrow the interval)",
                                   fewest_for_interval)
                           .c_str());
  return text;
}

std::vector<SphereKind> chosen_kinds(const std::vector<std::string>& names) {
  std::vector<SphereKind> chosen;
  std::vector<std::string> known;
  for (const SphereKind& kind : sphere_kinds()) {
    known.push_back(kind.name);
    if (names.empty() || std::ranges::count(names, kind.name)) chosen.push_back(kind);
  }
  for (const std::string& name : names) require_known("kind of spheres", name, known);
  return chosen;
}

}  // namespace

int crossover_command(const CommandLine& line, const CrossoverOptions& options) {
  const std::vector<SphereKind> chosen = chosen_kinds(options.kinds);
  std::vector<uint64_t> sizes = options.sizes;
  for (uint64_t n = 64; options.sizes.empty() && n <= 1 << 15; n *= 2) sizes.push_back(n);
  std::ranges::sort(sizes);
  StudyRun run(line, "crossover", options.results, options.backends);
  CrossoverSweep sweep(run.session(), options, [&] {
    run.record["auto"] = list_of(sweep.timings);
    run.record["stopped"] = sweep.stopped;
    run.record["measurements"] = sweep.measurements;
    run.write();
  });
  sweep.run(chosen, sizes);
  const auto tables = [&](size_t width) { return tables_of(sweep, width) + verdict(sweep.timings, width); };
  return run.finish(tables, sweep.measurements);
}

std::shared_ptr<CrossoverOptions> add_crossover_options(CLI::App& command) {
  auto options = std::make_shared<CrossoverOptions>();
  std::string help = "Only these of:\n";
  for (const SphereKind& kind : sphere_kinds()) help += fmt::format("    {:<9} {}\n", kind.name, kind.summary);
  add_backends_option(command, options->backends);
  add_list(command, "--n", options->sizes, "Numbers of spheres (default 64, 128 ... 32768)")->transform(positive_range);
  add_list(command, "--kinds", options->kinds, help);
  add_rounds_option(command, options->rounds);
  add_number(command, "--most-ms", options->most_ms, real_number(1e-3, 1e9),
             "A method whose step takes longer is not timed with more spheres");
  add_results_option(command, options->results, "crossover.json, .txt and .csv");
  command.footer("Example:\n  spherepair crossover --backends cpu,opengl --n 64,1024,16384");
  return options;
}

}  // namespace spherepair
