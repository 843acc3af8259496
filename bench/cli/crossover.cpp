// SPDX-License-Identifier: MIT
#include "bench/cli/crossover.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "bench/formats/files.h"
#include "bench/io/arguments.h"
#include "bench/io/context.h"
#include "bench/io/output_files.h"
#include "bench/options/options.h"
#include "bench/studies/crossover_sweep.h"

namespace spherepair {
namespace {

std::string ms_of(const std::map<std::string, double>& seconds, const std::string& way) {
  const auto found = seconds.find(way);
  return found == seconds.end() ? "-" : format_ms(found->second);
}

Table table_of(const CrossoverSweep& sweep) {
  Table table{"One collision step of all pairs, the grid and auto; every step sorts the spheres",
              {{"", "backend", "", true},
               {"", "spheres", "", true},
               {"", "n", ""},
               {"all pairs", "parallel", "ms"},
               {"all pairs", "square/32", "ms"},
               {"all pairs", "/64", "ms"},
               {"all pairs", "/128", "ms"},
               {"all pairs", "triangle", "ms"},
               {"grid", "dense", "ms"},
               {"grid", "hashed", "ms"},
               {"", "auto", "ms"},
               {"", "loss", "%"},
               {"", "auto chose", "", true},
               {"", "best", "", true}},
              {},
              sweep.stopped};
  for (const Timing& t : sweep.timings) {
    std::vector<std::string> row = {t.backend, t.kind, std::to_string(t.n), ms_of(t.all_pairs, "parallel")};
    for (const uint block : square_groups) row.push_back(ms_of(t.all_pairs, square_way(block)));
    row.insert(row.end(), {ms_of(t.all_pairs, "collide_triangle"), ms_of(t.grid, "dense"), ms_of(t.grid, "hashed"),
                           format_ms(t.automatic), format_percent(t.over_best - 1), t.chosen, t.best});
    table.rows.push_back(std::move(row));
  }
  return table;
}

// The size from which one of the two stays the faster; null if it is not the faster at the largest size.
template <typename Faster>
json faster_from(const std::vector<Timing>& timings, Faster faster) {
  json found = json::object();
  for (const Timing& t : timings) {
    json& from = found[t.backend][t.kind];
    if (!faster(t)) from = nullptr;
    if (faster(t) && from.is_null()) from = t.n;
  }
  return found;
}

bool triangle_fastest(const Timing& t) {
  const auto triangle = t.all_pairs.find(method_name(Method::collide_triangle));
  if (triangle == t.all_pairs.end()) return false;
  return std::ranges::all_of(t.all_pairs, [&](const auto& way) { return triangle->second <= way.second; });
}

std::vector<std::string> slow_choices(const std::vector<Timing>& timings) {
  std::vector<std::string> found;
  for (const Timing& t : timings)
    if (t.slower)
      found.push_back(fmt::format("{} {}, n = {}: {} takes {:.2f}x the time of {}", t.backend, t.kind, t.n, t.chosen,
                                  t.over_best, t.best));
  return found;
}

std::string verdict(const std::vector<Timing>& timings) {
  const std::vector<std::string> slower = slow_choices(timings);
  if (slower.empty())
    return fmt::format(
        "In all {} rows auto takes at most 1.1x the time of the best fixed choice, within the samples' spread\n",
        timings.size());
  std::string text = fmt::format(
      "WARNING: in {} of {} rows auto takes more than 1.1x the time of the best fixed choice, beyond the samples' "
      "spread:\n",
      slower.size(), timings.size());
  for (const std::string& row : slower) text += "  " + row + "\n";
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
  require_known_backends(options.backends);
  const std::vector<SphereKind> chosen = chosen_kinds(options.kinds);
  OutputFiles().write("--json", options.json_file);
  std::vector<uint64_t> sizes = options.sizes;
  for (uint64_t n = 64; options.sizes.empty() && n <= 1 << 15; n *= 2) sizes.push_back(n);
  std::ranges::sort(sizes);
  Session session(options.backends, line.open, line.opener);
  json record = {{"complete", false},
                 {"context", capture_context(line.words)},
                 {"backends", session.to_json()},
                 {"clocks", json::array({query_clocks()})}};
  std::optional<CrossoverSweep> sweep;
  const auto write = [&] {
    record["grid_from"] = faster_from(sweep->timings, [](const Timing& t) { return t.grid_faster(); });
    record["triangle_from"] = faster_from(sweep->timings, triangle_fastest);
    record["auto"] = list_of(sweep->timings);
    record["stopped"] = sweep->stopped;
    record["measurements"] = sweep->measurements;
    write_file(options.json_file, json_text(record));
  };
  sweep.emplace(session, options, write);
  sweep->run(chosen, sizes);
  record["complete"] = true;
  record["clocks"].push_back(query_clocks());
  write();
  fmt::print("{}\n", table_of(*sweep).text());
  for (const char* what : {"grid_from", "triangle_from"}) fmt::print("{}: {}\n", what, json_line(record[what]));
  fmt::print("{}", verdict(sweep->timings));
  return kOk;
}

std::shared_ptr<CrossoverOptions> add_crossover_options(CLI::App& command) {
  auto options = std::make_shared<CrossoverOptions>();
  std::string help = "Only these of:\n";
  for (const SphereKind& kind : sphere_kinds()) help += fmt::format("    {:<9} {}\n", kind.name, kind.summary);
  command.add_option("--backends", options->backends, "Only these, and each must open: cpu,glsl,cuda")->delimiter(',');
  command.add_option("--n", options->sizes, "Numbers of spheres (default 64, 128 ... 32768)")
      ->delimiter(',')
      ->check(positive_range);
  command.add_option("--kinds", options->kinds, help)->delimiter(',');
  command.add_option("--rounds", options->rounds, "Rounds of each timing")
      ->check(whole_number(1, 1000))
      ->capture_default_str();
  command.add_option("--most-ms", options->most_ms, "A method whose step takes longer is not timed with more spheres")
      ->check(real_number(1e-3, 1e9))
      ->capture_default_str();
  command.add_option("--json", options->json_file, "Output file")->capture_default_str();
  command.footer("Example:\n  spherepair crossover --backends cpu,glsl --n 64,1024,16384");
  return options;
}

}  // namespace spherepair
