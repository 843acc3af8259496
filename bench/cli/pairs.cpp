// SPDX-License-Identifier: MIT
// spherepair pairs
#include <fmt/format.h>

#include <chrono>
#include <cstdio>

#include "bench/check/step_result.h"
#include "bench/cli/commands.h"
#include "bench/formats/files.h"
#include "bench/io/arguments.h"
#include "bench/io/context.h"
#include "bench/io/output_files.h"
#include "bench/measure/choice.h"
#include "bench/npy/rows_file.h"
#include "bench/output/pair_file.h"
#include "bench/spheres/sphere_file.h"
#include "common/lists/host_lists.h"
#include "common/lists/pair_list.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

struct Found {
  std::vector<ListedPair> list;  // full with --csr, else half
  uint64_t pairs = 0;            // of either: each counts once
  Fingerprint fingerprint;
  std::vector<uint> counts;            // neighbours of each sphere, images included
  std::optional<MethodChoice> method;  // of the search; none: host threads made the list, row by row
};

struct Seconds {
  double load = 0, open = 0, collide = 0, write = 0;
};

// Options and results, for the summary and the JSON.
struct PairsReport {
  const PairsOptions& options;
  SphereFile input;
  ChosenBackend chosen;
  Found found;
  Seconds seconds;
};

template <typename Work>
double seconds_of(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

SphereFile read_input(const PairsOptions& options, int threads) {
  SphereFile input =
      read_sphere_file(options.input_file, {.radius = options.cutoff ? std::optional(0.0) : options.radius,
                                            .frame = options.frame,
                                            .columns = options.columns,
                                            .decimal_comma = options.decimal_comma,
                                            .ignore_radii = options.cutoff.has_value(),
                                            .ignore_periodic = options.ignore_periodic,
                                            .exact = true,
                                            .threads = threads});
  ListProblem& problem = input.given;
  problem.half = !options.csr;
  if (options.cutoff) problem.cutoff = *options.cutoff, problem.inclusive = true, problem.set.radii.clear();
  return input;
}

Found find_pairs(Search& search, const SphereFile& input, const CollideOptions& options) {
  const ListProblem& problem = input.given;
  Found found;
  try {
    check_problem(problem);
    PairRows rows;
    const int threads = options.method == Method::automatic ? list_threads(search) : 0;
    if (!threads || !HostLists(threads).list(problem, true, rows)) {
      rows = list_by_search(search, problem, options);
      found.method = search.choice(options);
    }
    found.list = rows.pairs();
  } catch (const ListError& error) {
    throw std::invalid_argument(fmt::format("{}: {}", input.file, error.what()));
  }
  found.counts.resize(problem.set.size());
  for (const auto& [first, second, shift] : found.list) {
    ++found.counts[first];
    if (problem.half) ++found.counts[second];
    if (first > second || (first == second && shift < Shift{})) continue;  // the other half
    ++found.pairs;
    found.fingerprint.a += pair_mix_a(first, second), found.fingerprint.b += pair_mix_b(first, second);
  }
  return found;
}

void write_found(const PairsOptions& options, const ListProblem& problem, const Found& found) {
  const std::string& file = options.output_file;
  if (!options.contacts_file.empty()) write_contact_numbers(options.contacts_file, found.counts);
  if (options.csr)
    write_neighbours(neighbour_files(file, options.distances), problem, found.list);
  else if (!file.empty())
    write_listed(file, problem, found.list, {options.distances, options.geometry});
}

std::string describe_points(const PairsReport& report) {
  const SphereFile& input = report.input;
  if (!report.options.cutoff) return describe_radii(input);
  return fmt::format("{}, cutoff {}{}\n", counted(input.size(), "point"), *report.options.cutoff,
                     input.unused_radii ? "; the file's radii are not used" : "");
}

size_t colliding_spheres(const Found& found) {
  return found.counts.size() - size_t(std::ranges::count(found.counts, 0u));
}

std::string name_of(const std::optional<MethodChoice>& method) { return method ? method_name(method->method) : "rows"; }

// The text that only --verbose prints, after the summary.
std::string details(const PairsReport& report) {
  const auto& [options, input, chosen, found, seconds] = report;
  std::string text =
      passed_over_text(chosen) +
      wrapped("method: " + (found.method ? describe(*found.method) : "rows, by the host's threads"), "", "  ") + "\n";
  text += fmt::format("seconds: load {:.3f}, open {:.3f}, collide {:.3f}, write {:.3f}\n", seconds.load, seconds.open,
                      seconds.collide, seconds.write);
  return text;
}

std::string summary(const PairsReport& report) {
  const auto& [options, input, chosen, found, seconds] = report;
  std::string text = describe_file(input) + describe_points(report);
  text += wrapped(fmt::format("{} on {}, {}", chosen.backend->info().name, device_label(chosen.backend->info()),
                              name_of(found.method)),
                  "", "  ") +
          "\n";
  text += fmt::format("{}, {} of {} {}; {:.3f} s\n", counted(found.pairs, "pair"), colliding_spheres(found),
                      counted(input.size(), options.cutoff ? "point" : "sphere"),
                      options.cutoff ? "have a neighbour" : "collide",
                      seconds.load + seconds.open + seconds.collide + seconds.write);
  return text + (options.verbosity == Verbosity::verbose ? details(report) : "");
}

// Prints warnings on standard error: causes of a changed result, and without --quiet causes of a slow search.
void print_warnings(const PairsReport& report) {
  fmt::print(stderr, "{}", box_warning(report.input));
  if (report.options.verbosity != Verbosity::quiet)
    for (const std::string& warning : report.chosen.session->warnings()) fmt::print(stderr, "{}\n", warning);
}

json to_json(const PairsReport& report, const CommandLine& line) {
  const auto& [options, input, chosen, found, seconds] = report;
  return {{"context", capture_context(line.words)},
          {"backends", chosen.session->to_json()},
          {"passed_over", chosen.passed_over},
          {"input", to_json(input)},
          {"method", name_of(found.method)},
          {"choice", found.method ? to_json(*found.method) : json(nullptr)},
          {"block", found.method && found.method->block ? json(found.method->block) : json(nullptr)},
          {"cutoff", options.cutoff ? json(*options.cutoff) : json(nullptr)},
          {"output", options.output_file},
          {"pairs", found.pairs},
          {"colliding_spheres", colliding_spheres(found)},
          {"fingerprint", hex64(found.fingerprint.a) + hex64(found.fingerprint.b)},
          {"seconds",
           {{"load", seconds.load}, {"open", seconds.open}, {"collide", seconds.collide}, {"write", seconds.write}}}};
}

}  // namespace

int pairs_command(const CommandLine& line, const PairsOptions& options) {
  check_pairs_options(options);
  PairsReport report{options, {}, {}, {}, {}};
  SphereFile& input = report.input;
  ChosenBackend& chosen = report.chosen;
  Seconds& seconds = report.seconds;
  Progress progress(options.verbosity != Verbosity::quiet);
  progress.say("reading " + options.input_file);
  seconds.load = seconds_of([&] { input = read_input(options, line.open.threads); });
  progress.say("opening a backend");
  seconds.open = seconds_of([&] { chosen = choose_backend(options.backend, line.open, line.opener); });
  progress.say(fmt::format("{} on {}", counted(input.size(), "sphere"), chosen.backend->info().name));
  CollideOptions collide = {.method = choose_method(options.method, *chosen.backend)};
  if (options.block) collide.block = require_groups({chosen.backend, collide}, options.block);
  seconds.collide = seconds_of([&] { report.found = find_pairs(*chosen.backend, input, collide); });
  progress.say("writing " + options.output_file);
  seconds.write = seconds_of([&] { write_found(options, input.given, report.found); });
  progress.clear();
  print_warnings(report);
  const bool taken = is_standard_output({options.output_file, options.contacts_file, options.json_file});
  if (options.verbosity != Verbosity::quiet) fmt::print(taken ? stderr : stdout, "{}", summary(report));
  write_json(options.json_file, to_json(report, line));
  return kOk;
}

}  // namespace spherepair
