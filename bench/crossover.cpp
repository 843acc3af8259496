// SPDX-License-Identifier: MIT
#include "crossover.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "arguments.h"
#include "context.h"
#include "crossover_sweep.h"
#include "files.h"
#include "options.h"
#include "replaced_file.h"

namespace spherepair {
namespace {

std::string ms_of(const Timing& timing, const char* name) {
  const auto found = timing.seconds.find(name);
  return found == timing.seconds.end() ? "-" : format_ms(found->second);
}

Table table_of(const std::vector<Timing>& timings) {
  Table table{"One collision step of all pairs, of the grid and of auto; every step sorts the spheres anew",
              {{"", "backend", "", true},
               {"", "spheres", "", true},
               {"", "n", ""},
               {"", "all pairs", "ms"},
               {"grid", "dense", "ms"},
               {"grid", "hashed", "ms"},
               {"", "auto", "ms"},
               {"", "over best", "%"},
               {"", "auto took", "", true}},
              {},
              {}};
  for (const Timing& t : timings)
    table.rows.push_back({t.backend, t.kind, std::to_string(t.n), ms_of(t, "all pairs"), ms_of(t, "dense"),
                          ms_of(t, "hashed"), ms_of(t, "auto"), format_percent(t.over_best - 1), t.took});
  return table;
}

// From which size on the grid stays ahead.
json crossovers_of(const std::vector<Timing>& timings) {
  json found = json::object();
  for (const Timing& t : timings) {
    json& from = found[t.backend][t.kind];
    if (!t.grid_ahead()) from = nullptr;
    if (t.grid_ahead() && from.is_null()) from = t.n;
  }
  return found;
}

std::vector<std::string> objections(const std::vector<Timing>& timings) {
  std::vector<std::string> found;
  for (const Timing& t : timings)
    if (t.slower)
      found.push_back(
          fmt::format("{} {} of {}: {:.0f} % over the best", t.backend, t.kind, t.n, 100 * (t.over_best - 1)));
  return found;
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
  require_known_backends(options.backends);
  const std::vector<SphereKind> chosen = chosen_kinds(options.kinds);
  check_writable(options.json_file);
  std::vector<uint64_t> sizes = options.sizes;
  for (uint64_t n = 64; options.sizes.empty() && n <= 1 << 17; n *= 2) sizes.push_back(n);
  std::ranges::sort(sizes);
  Session session(options.backends, line.open);
  json record = {{"context", capture_context(line.words)},
                 {"backends", session.to_json()},
                 {"clocks", json::array({query_clocks()})}};
  CrossoverSweep sweep(session, options);
  for (const SphereKind& kind : chosen) sweep.walk(kind, sizes);
  const std::vector<std::string> slower = objections(sweep.timings);
  record["clocks"].push_back(query_clocks());
  record["crossovers"] = crossovers_of(sweep.timings);
  record["auto_slower"] = slower;
  record["measurements"] = sweep.measurements;
  write_file(options.json_file, json_text(record));
  fmt::print("{}\nThe grid stays ahead from n on: {}\n", table_of(sweep.timings).text(), record["crossovers"].dump());
  fmt::print("auto is {} by more than 10 % of the best fixed choice{}\n", slower.empty() ? "never slower" : "slower",
             slower.empty() ? "" : ":");
  for (const std::string& objection : slower) fmt::print("  {}\n", objection);
  return kOk;
}

std::shared_ptr<CrossoverOptions> add_crossover_options(CLI::App& command) {
  auto options = std::make_shared<CrossoverOptions>();
  std::string help = "Only these of:\n";
  for (const SphereKind& kind : sphere_kinds()) help += fmt::format("    {:<9} {}\n", kind.name, kind.summary);
  command.add_option("--backends", options->backends, "Only these, and each must open: cpu,glsl,cuda")->delimiter(',');
  command.add_option("--n", options->sizes, "Numbers of spheres (default 64, 128 ... 131072)")
      ->delimiter(',')
      ->check(positive_range);
  command.add_option("--kinds", options->kinds, help)->delimiter(',');
  command.add_option("--rounds", options->rounds, "Rounds of each timing")
      ->check(whole_number(1, 1000))
      ->capture_default_str();
  command.add_option("--most-ms", options->most_ms, "What takes longer a step is not tried at more spheres")
      ->capture_default_str();
  command.add_option("--json", options->json_file, "The record")->capture_default_str();
  command.footer("Example:\n  spherepair crossover --backends cpu,glsl --n 64,1024,16384");
  return options;
}

}  // namespace spherepair
