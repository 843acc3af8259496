// SPDX-License-Identifier: MIT
// spherepair pairs
#include <fmt/format.h>

#include <chrono>
#include <cstdio>

#include "bench/check/degrees.h"
#include "bench/check/rounding_reach.h"
#include "bench/check/step_result.h"
#include "bench/cli/commands.h"
#include "bench/formats/files.h"
#include "bench/io/arguments.h"
#include "bench/io/context.h"
#include "bench/io/output_files.h"
#include "bench/lists/listed_file.h"
#include "bench/lists/listed_spheres.h"
#include "bench/measure/choice.h"
#include "bench/npy/rows_file.h"
#include "bench/output/pair_file.h"
#include "bench/spheres/sphere_file.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

struct Found {
  Collisions totals;
  Degrees degrees;
  std::vector<uint> counts;
  std::vector<Pair> pairs;
  std::vector<ListedPair> listed;  // replaces `pairs` in a periodic box
  uint64_t within_reach = 0;       // pairs that rounding to float32 may have decided
};

struct Seconds {
  double load = 0, open = 0, collide = 0, write = 0;
};

// Options and results, for the summary and the JSON.
struct PairsReport {
  const PairsOptions& options;
  SphereFile input;
  ChosenBackend chosen;
  MethodChoice method = {};
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
  SphereFileOptions how = {.radius = options.radius,
                           .frame = options.frame,
                           .columns = options.columns,
                           .decimal_comma = options.decimal_comma,
                           .ignore_radii = options.cutoff.has_value(),
                           .ignore_periodic = options.ignore_periodic,
                           .take_periodic = true,
                           .may_shift = true,
                           .threads = threads};
  if (options.cutoff) how.radius = radius_above(*options.cutoff);
  SphereFile input = read_sphere_file(options.input_file, how);
  if (options.cutoff) widen(input.rounding, *how.radius - *options.cutoff / 2);
  return input;
}

// Removes pairs that are farther apart than the cutoff: the search uses slightly larger spheres.
void leave_pairs_beyond(double cutoff, std::span<const vec4> points, Found& found) {
  std::erase_if(found.pairs, [&](const Pair& pair) {
    if (is_within(pair, points, cutoff)) return false;
    --found.counts[pair.first], --found.counts[pair.second];
    return true;
  });
  if (found.pairs.size() == found.totals.pairs) return;
  found.totals.pairs = found.pairs.size();
  found.totals.colliding_spheres = found.counts.size() - size_t(std::ranges::count(found.counts, 0u));
  found.totals.fingerprint = fingerprint(found.pairs);
}

Found find_listed(Search& search, const SphereFile& input, const PairsOptions& options, const CollideOptions& how) {
  Found found;
  ListedSpheres listed = find_listed(search, input, options.cutoff, options.csr, how);
  found.totals = listed.totals;
  found.counts = std::move(listed.counts);
  found.listed = std::move(listed.pairs);
  found.degrees = degrees_of(found.counts);
  return found;
}

Found find_pairs(Search& search, const SphereFile& input, const CollideOptions& options, std::optional<double> cutoff) {
  Found found;
  found.within_reach = pairs_within_reach(search, input.scene, input.rounding, options);
  search.upload(input.scene);
  search.collide(options);
  found.totals = search.collisions();
  found.counts = search.counts();
  if (options.want_pairs) found.pairs = search.pairs();
  if (cutoff) leave_pairs_beyond(*cutoff, input.scene.positions, found);
  found.degrees = degrees_of(found.counts);
  return found;
}

void write_found(const PairsOptions& options, const SphereFile& input, const Found& found) {
  const std::string& file = options.output_file;
  const std::vector<vec4>& spheres = input.scene.positions;
  if (!options.contacts_file.empty()) write_contact_numbers(options.contacts_file, found.counts);
  if (input.periodic && !file.empty()) {
    const ListProblem problem = problem_of(*input.periodic, options.cutoff, options.csr);
    if (options.csr) return write_listed_neighbours(neighbour_files(file, options.distances), problem, found.listed);
    return write_listed(file, problem, found.listed, options.distances);
  }
  if (options.csr)
    write_neighbours(neighbour_files(file, options.distances), found.pairs, found.counts, spheres);
  else if (options.geometry)
    write_contacts(file, found.pairs, spheres, input.rounding.shift);
  else if (options.distances)
    write_distances(file, found.pairs, spheres);
  else if (!file.empty())
    write_pairs(file, found.pairs);
}

std::string describe_points(const PairsReport& report) {
  const SphereFile& input = report.input;
  if (!report.options.cutoff) return describe_radii(input);
  return fmt::format("{}, cutoff {}{}\n", counted(input.scene.size(), "point"), *report.options.cutoff,
                     input.unused_radii ? "; the file's radii are not used" : "");
}

// The text that only --verbose prints, after the summary.
std::string details(const PairsReport& report) {
  const auto& [options, input, chosen, method, found, seconds] = report;
  std::string text = passed_over_text(chosen) + wrapped("method: " + describe(method), "", "  ") + "\n";
  if (found.totals.deferred)
    text += fmt::format("left to the exact stages by the float32 filter: {}; decided in float64 {}, in integers {}\n",
                        counted(found.totals.deferred, "pair"), found.totals.decided_by[STAGE_DOUBLE],
                        found.totals.decided_by[STAGE_INTEGER] + found.totals.decided_by[STAGE_WIDE]);
  text += fmt::format("seconds: load {:.3f}, open {:.3f}, collide {:.3f}, write {:.3f}\n", seconds.load, seconds.open,
                      seconds.collide, seconds.write);
  if (found.degrees.spheres) text += "\n" + degree_table(found.degrees).text();
  return text;
}

std::string summary(const PairsReport& report) {
  const auto& [options, input, chosen, method, found, seconds] = report;
  const bool verbose = options.verbosity == Verbosity::verbose;
  std::string text = describe_file(input) + describe_points(report);
  if (input.periodic) text += "decided by the file's numbers, none of which is rounded\n";
  if (verbose && !input.periodic) text += describe_digits(input);
  text += describe_rounding(input);
  text += wrapped(fmt::format("{} on {}, {}", chosen.backend->info().name, device_label(chosen.backend->info()),
                              method_name(method.method)),
                  "", "  ") +
          "\n";
  text += fmt::format("{}, {} of {} {}; {:.3f} s\n", counted(found.totals.pairs, "pair"),
                      found.totals.colliding_spheres, counted(input.scene.size(), options.cutoff ? "point" : "sphere"),
                      options.cutoff ? "have a neighbour" : "collide",
                      seconds.load + seconds.open + seconds.collide + seconds.write);
  return text + (verbose ? details(report) : "");
}

// Prints warnings on standard error: causes of a changed result, and without --quiet causes of a slow search.
void print_warnings(const PairsReport& report) {
  fmt::print(stderr, "{}", box_warning(report.input));
  if (report.options.verbosity != Verbosity::quiet)
    for (const std::string& warning : report.chosen.session->warnings()) fmt::print(stderr, "{}\n", warning);
  const std::string warning =
      reach_warning(report.found.within_reach, report.input.rounding, report.options.cutoff.has_value());
  if (!warning.empty()) fmt::print(stderr, "{}\n", wrapped(warning, "* ", "  "));
}

json to_json(const PairsReport& report, const CommandLine& line) {
  const auto& [options, input, chosen, method, found, seconds] = report;
  return {{"context", capture_context(line.words)},
          {"backends", chosen.session->to_json()},
          {"passed_over", chosen.passed_over},
          {"input", to_json(input)},
          {"method", method_name(method.method)},
          {"choice", to_json(method)},
          {"block", method.block ? json(method.block) : json(nullptr)},
          {"cutoff", options.cutoff ? json(*options.cutoff) : json(nullptr)},
          {"output", options.output_file},
          {"pairs", found.totals.pairs},
          {"pairs_within_rounding", found.within_reach},
          {"colliding_spheres", found.totals.colliding_spheres},
          {"fingerprint", hex64(found.totals.fingerprint.a) + hex64(found.totals.fingerprint.b)},
          {"deferred", found.totals.deferred},
          {"decided_by_stage", found.totals.decided_by},
          {"degrees", to_json(found.degrees)},
          {"seconds",
           {{"load", seconds.load}, {"open", seconds.open}, {"collide", seconds.collide}, {"write", seconds.write}}}};
}

}  // namespace

int pairs_command(const CommandLine& line, const PairsOptions& options) {
  check_pairs_options(options);
  PairsReport report{options, {}, {}, {}, {}, {}};
  SphereFile& input = report.input;
  ChosenBackend& chosen = report.chosen;
  Seconds& seconds = report.seconds;
  Progress progress(options.verbosity != Verbosity::quiet);
  progress.say("reading " + options.input_file);
  seconds.load = seconds_of([&] { input = read_input(options, line.open.threads); });
  if (input.periodic) check_periodic_options(options);
  progress.say("opening a backend");
  seconds.open = seconds_of([&] { chosen = choose_backend(options.backend, line.open, line.opener); });
  progress.say(fmt::format("{} on {}", counted(input.scene.size(), "sphere"), chosen.backend->info().name));
  CollideOptions collide = {.method = choose_method(options.method, *chosen.backend),
                            .want_pairs = !options.output_file.empty() || options.cutoff};
  if (options.block) collide.block = require_groups({chosen.backend, collide}, options.block);
  seconds.collide = seconds_of([&] {
    report.found = input.periodic ? find_listed(*chosen.backend, input, options, collide)
                                  : find_pairs(*chosen.backend, input, collide, options.cutoff);
  });
  report.method = chosen.backend->choice(collide);
  progress.say("writing " + options.output_file);
  seconds.write = seconds_of([&] { write_found(options, input, report.found); });
  progress.clear();
  print_warnings(report);
  const bool taken = is_standard_output({options.output_file, options.contacts_file, options.json_file});
  if (options.verbosity != Verbosity::quiet) fmt::print(taken ? stderr : stdout, "{}", summary(report));
  write_json(options.json_file, to_json(report, line));
  return kOk;
}

}  // namespace spherepair
