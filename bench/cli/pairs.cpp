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
#include "bench/measure/choice.h"
#include "bench/spheres/pair_file.h"
#include "bench/spheres/sphere_file.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

struct Found {
  Collisions totals;
  Degrees degrees;
  std::vector<uint> counts;
  std::vector<Pair> pairs;
  uint64_t within_reach = 0;  // of rounding to float32
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

// Throws for bad options before any work.
void check_options(const PairsOptions& options) {
  if (!options.backend.empty()) require_known_backends({options.backend});
  if (!options.method.empty() && method_from_name(options.method) == Method::collide_group)
    throw std::invalid_argument("the method collide_group finds only pairs within a group; choose another");
  if (options.block) parse_blocks({options.block});
  OutputFiles files;
  files.read("--input", options.input_file);
  files.write("--output", options.output_file);
  files.write("--contacts", options.contacts_file);
  files.write("--json", options.json_file);
  check_pair_file("--output", options.output_file);
  check_pair_file("--contacts", options.contacts_file);
}

template <typename Work>
double seconds_of(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Found find_pairs(Backend& backend, const SphereFile& input, const CollideOptions& options) {
  Found found;
  found.within_reach = pairs_within_reach(backend, input.scene, input.rounding, options);
  backend.upload(input.scene);
  backend.collide(options);
  found.totals = backend.collisions();
  found.counts = backend.counts();
  found.degrees = degrees_of(found.counts);
  found.pairs = backend.pairs();
  return found;
}

void write_found(const PairsOptions& options, const SphereFile& input, const Found& found) {
  if (options.geometry)
    write_contacts(options.output_file, found.pairs, input.scene.positions, input.rounding.shift);
  else
    write_pairs(options.output_file, found.pairs);
  if (!options.contacts_file.empty()) write_contact_numbers(options.contacts_file, found.counts);
}

std::string summary(const PairsReport& report) {
  const auto& [options, input, chosen, method, found, seconds] = report;
  std::string text = describe(input);
  text += wrapped(fmt::format("{} on {}, {}", chosen.backend->info().name, device_label(chosen.backend->info()),
                              describe(method)),
                  "", "  ") +
          "\n";
  text += passed_over_text(chosen);
  text += fmt::format("{}, {} of {} collide\n", counted(found.totals.pairs, "pair"), found.totals.colliding_spheres,
                      counted(input.scene.size(), "sphere"));
  text += fmt::format("seconds: load {:.3f}, open {:.3f}, collide {:.3f}, write {:.3f}\n\n", seconds.load, seconds.open,
                      seconds.collide, seconds.write);
  if (found.degrees.spheres) text += degree_table(found.degrees).text();
  return text;
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
  check_options(options);
  PairsReport report{options, {}, {}, {}, {}, {}};
  SphereFile& input = report.input;
  ChosenBackend& chosen = report.chosen;
  Seconds& seconds = report.seconds;
  Progress progress;
  progress.say("reading " + options.input_file);
  seconds.load = seconds_of([&] {
    input = read_sphere_file(options.input_file, {.radius = options.radius,
                                                  .frame = options.frame,
                                                  .columns = options.columns,
                                                  .decimal_comma = options.decimal_comma,
                                                  .ignore_periodic = options.ignore_periodic,
                                                  .may_shift = true,
                                                  .threads = line.open.threads});
  });
  progress.say("opening a backend");
  seconds.open = seconds_of([&] { chosen = choose_backend(options.backend, line.open); });
  progress.say(fmt::format("{} on {}", counted(input.scene.size(), "sphere"), chosen.backend->info().name));
  CollideOptions collide = {.method = choose_method(options.method, *chosen.backend), .want_pairs = true};
  if (options.block) collide.block = require_groups({chosen.backend, collide}, options.block);
  seconds.collide = seconds_of([&] { report.found = find_pairs(*chosen.backend, input, collide); });
  report.method = chosen.backend->choice(collide);
  progress.say("writing " + options.output_file);
  seconds.write = seconds_of([&] { write_found(options, input, report.found); });
  progress.clear();
  for (const std::string& warning : chosen.session->warnings()) fmt::print(stderr, "{}\n", warning);
  const std::string warning = reach_warning(report.found.within_reach, input.rounding);
  if (!warning.empty()) fmt::print(stderr, "{}\n", wrapped(warning, "* ", "  "));
  const bool taken = is_standard_output({options.output_file, options.contacts_file, options.json_file});
  fmt::print(taken ? stderr : stdout, "{}", summary(report));
  write_json(options.json_file, to_json(report, line));
  return kOk;
}

}  // namespace spherepair
