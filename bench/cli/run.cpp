// SPDX-License-Identifier: MIT
// spherepair run
#include <fmt/format.h>

#include "bench/check/finite_state.h"
#include "bench/check/step_result.h"
#include "bench/cli/commands.h"
#include "bench/formats/files.h"
#include "bench/io/arguments.h"
#include "bench/io/context.h"
#include "bench/io/scene_text.h"
#include "bench/measure/choice.h"
#include "bench/output/pair_file.h"
#include "bench/output/sphere_output.h"
#include "bench/run/run_files.h"
#include "bench/run/run_steps.h"
#include "common/backend/checks.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

// --save may overwrite --resume: the checkpoint is read completely before it is replaced.
void check_files(const RunOptions& options) {
  OutputFiles files;
  add_inputs(files, options.start);
  files.write("--save", options.save_file, "--resume");
  files.write("--pairs", options.pairs_file);
  files.write("--contacts", options.contacts_file);
  files.write("--spheres", options.spheres_file);
  files.write("--statistics", options.statistics_file);
  files.write("--trajectory", options.trajectory_file);
  files.write("--json", options.json_file);
  check_pair_file("--pairs", options.pairs_file);
  check_pair_file("--contacts", options.contacts_file);
  check_sphere_output("--spheres", options.spheres_file);
  check_trajectory(options);
}

CollideOptions collide_options(const RunOptions& options, Backend& backend) {
  CollideOptions collide;
  collide.swept = options.swept;
  collide.method = choose_method(options.method, backend);
  if (options.block) collide.block = require_groups({&backend, collide}, parse_blocks({options.block}).front());
  collide.exact = !options.naive;
  return collide;
}

std::string steps_text(const std::vector<RunStep>& results, bool hashes) {
  Table table{"", {{"", "step", ""}, {"", "pairs", ""}, {"", "colliding", "spheres"}}, {}, {}};
  if (hashes)
    for (const char* name : {"fingerprint of the pairs", "hash of the state"})
      table.columns.push_back({"", name, "", true});
  for (const auto& [step, state, totals] : results) {
    table.rows.push_back(
        {std::to_string(step), std::to_string(totals.pairs), std::to_string(totals.colliding_spheres)});
    if (!hashes) continue;
    table.rows.back().push_back(hex64(totals.fingerprint.a) + hex64(totals.fingerprint.b));
    table.rows.back().push_back(hex64(state));
  }
  return table.text().substr(1);
}

struct Outcome {
  std::vector<RunStep> steps;
  RunSummary summary;
};

json run_record(const CommandLine& line, const ChosenBackend& chosen, const Start& start, const CollideOptions& collide,
                const MethodChoice& choice, const Outcome& outcome, const RunTimes& times) {
  return {{"context", capture_context(line.words)},
          {"backends", chosen.session->to_json()},
          {"passed_over", chosen.passed_over},
          {"scene", start.record},
          {"motion", motion_label(start.scene.motion)},
          {"dt", start.scene.dt},
          {"restitution", start.scene.restitution},
          {"plane", start.scene.plane},
          {"gravity", start.scene.gravity},
          {"contacts", contact_json(start.scene.contact)},
          {"method", method_name(choice.method)},
          {"choice", to_json(choice)},
          {"block", choice.block ? choice.block : collide.block},
          {"exact", collide.exact},
          {"swept", collide.swept},
          {"times", times.to_json()},
          {"end", to_json(outcome.summary)},
          {"steps", list_of(outcome.steps)}};
}

std::string heading(const RunOptions& options, const ChosenBackend& chosen, const Start& start,
                    const CollideOptions& collide, uint64_t steps) {
  const Backend& backend = *chosen.backend;
  const std::string what = fmt::format("{} on {}: {}{}, scene {}, {}, {} of {}", backend.info().name,
                                       device_label(backend.info()), label({chosen.backend, collide}),
                                       options.naive   ? " (naive)"
                                       : options.swept ? " (within the next step)"
                                                       : "",
                                       start.label, counted(start.scene.size(), "sphere"), counted(steps, "step"),
                                       motion_label(start.scene.motion));
  std::string text = start.notes + wrapped(what, "", "  ") + "\n";
  const bool details = options.verbosity == Verbosity::verbose;
  if (details) text += passed_over_text(chosen);
  if (steps || options.swept) text += plane_text(start.scene) + describe_contacts(start.scene);
  if (details && collide.method == Method::automatic)
    text += wrapped("auto: " + describe(backend.choice(collide)), "", "  ") + "\n";
  return text;
}

// The report of a run; --quiet prints none of it.
std::string report_text(const RunOptions& options, const ChosenBackend& chosen, const Start& start,
                        const CollideOptions& collide, const Outcome& outcome, const RunTimes& times) {
  if (options.verbosity == Verbosity::quiet) return "";
  const uint64_t steps = outcome.summary.step - start.step;
  const bool details = options.verbosity == Verbosity::verbose;
  std::string text = heading(options, chosen, start, collide, steps);
  text += steps_text(outcome.steps, details || options.hashes);
  if (steps) text += text_of(outcome.summary);
  return text + (details ? times.text() : fmt::format("{:.3f} s in all\n", times.total()));
}

Outcome simulate(Backend& backend, const RunOptions& options, const Start& start, const CollideOptions& collide,
                 RunTimes& times) {
  times.spend(RunTimes::opening, [&] { upload_start(start, backend); });
  Run simulation(backend, options, start, collide, times);
  std::vector<RunStep> steps = simulation.simulate();
  return {std::move(steps), simulation.summary()};
}

}  // namespace

int run_command(const CommandLine& line, const RunOptions& options) {
  if (options.save_every && options.save_file.empty())
    throw std::invalid_argument("--save-every needs a file name: --save FILE");
  check_files(options);
  RunTimes times;
  const Start start = times.spend(RunTimes::spheres, [&] { return start_of(options.start, line.open.threads); });
  check_scene(start.scene);
  if (!options.statistics_file.empty() && start.scene.contact.law == ContactLaw::none)
    throw std::invalid_argument("--statistics is of contacts that push: omit it, or give --contact spring");
  if (options.until_rest && !(start.scene.contact.drag > 0))
    throw std::invalid_argument("--until-rest needs --drag, without which no sphere comes to rest to the bit");
  const bool moves = end_of(options, start) > start.step;
  if (options.swept && start.scene.contact.drag > 0)
    throw std::invalid_argument(
        start.motion ? "--swept tests paths without drag, and the checkpoint's run has drag: omit --swept"
                     : "--swept tests paths without drag: omit it, or --drag");
  const ChosenBackend chosen =
      times.spend(RunTimes::opening, [&] { return choose_backend(options.backend, line.open, line.opener); });
  Backend& backend = *chosen.backend;
  const CollideOptions collide = collide_options(options, backend);
  if (start.scene.contact.periodic) check_images(collide);
  if (!options.statistics_file.empty() && (!collide.exact || collide.swept || collide.method == Method::collide_group))
    throw std::invalid_argument(
        "--statistics needs every pair of the exact test: omit --naive, --swept and --method collide_group");
  for (const std::string& warning : chosen.session->warnings()) fmt::print(stderr, "{}\n", warning);
  if (moves) fmt::print(stderr, "{}", stalled_warning(start.scene));
  if (!options.spheres_file.empty()) fmt::print(stderr, "{}", species_warning(start));
  const Outcome outcome = simulate(backend, options, start, collide, times);
  if (!options.pairs_file.empty()) write_pairs(options.pairs_file, backend.pairs());
  if (!options.contacts_file.empty()) write_contact_numbers(options.contacts_file, backend.counts());
  if (!options.spheres_file.empty()) {
    const Motion::State state = current_state(backend);
    write_spheres(options.spheres_file, state.positions, state.velocities, box_of(start.scene));
  }
  const bool taken = is_standard_output({options.pairs_file, options.contacts_file, options.spheres_file,
                                         options.statistics_file, options.trajectory_file, options.json_file});
  std::FILE* report = taken ? stderr : stdout;
  fmt::print(report, "{}", report_text(options, chosen, start, collide, outcome, times));
  write_json(options.json_file, run_record(line, chosen, start, collide, backend.choice(collide), outcome, times));
  return kOk;
}

}  // namespace spherepair
