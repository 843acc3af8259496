// SPDX-License-Identifier: MIT
// spherepair run
#include <fmt/format.h>

#include "bench/check/finite_state.h"
#include "bench/check/missed_contacts.h"
#include "bench/check/rounding_reach.h"
#include "bench/check/step_result.h"
#include "bench/cli/commands.h"
#include "bench/formats/checkpoint.h"
#include "bench/formats/files.h"
#include "bench/io/arguments.h"
#include "bench/io/context.h"
#include "bench/measure/choice.h"
#include "bench/spheres/pair_file.h"

namespace spherepair {
namespace {

// --save may overwrite --resume: the checkpoint is read completely before it is replaced.
void check_files(const RunOptions& options) {
  OutputFiles files;
  add_inputs(files, options.start);
  files.write("--save", options.save_file, "--resume");
  files.write("--pairs", options.pairs_file);
  files.write("--contacts", options.contacts_file);
  files.write("--json", options.json_file);
  check_pair_file("--pairs", options.pairs_file);
  check_pair_file("--contacts", options.contacts_file);
}

struct RunStep {
  uint64_t step, state;
  Collisions totals;
};

CollideOptions collide_options(const RunOptions& options, const Backend& backend) {
  CollideOptions collide;
  collide.swept = options.swept;
  const bool swept_by_default = options.swept && options.method.empty();
  collide.method = swept_by_default ? swept_method(backend) : choose_method(options.method, backend);
  collide.block = parse_blocks({options.block}).front();
  collide.exact = !options.naive;
  return collide;
}

json to_json(const RunStep& result) {
  const Collisions& totals = result.totals;
  return {{"step", result.step},
          {"pairs", totals.pairs},
          {"colliding_spheres", totals.colliding_spheres},
          {"fingerprint", hex64(totals.fingerprint.a) + hex64(totals.fingerprint.b)},
          {"state", hex64(result.state)},
          {"deferred", totals.deferred},
          {"decided_by_stage", totals.decided_by}};
}

void print_steps(const std::vector<RunStep>& results) {
  Table table{"",
              {{"", "step", ""},
               {"", "pairs", ""},
               {"", "colliding", "spheres"},
               {"", "undecided", "by float32"},
               {"", "fingerprint of the pairs", "", true},
               {"", "hash of the state", "", true}},
              {},
              {}};
  for (const auto& [step, state, totals] : results)
    table.rows.push_back({std::to_string(step), std::to_string(totals.pairs), std::to_string(totals.colliding_spheres),
                          std::to_string(totals.deferred), hex64(totals.fingerprint.a) + hex64(totals.fingerprint.b),
                          hex64(state)});
  fmt::print("{}", table.text().substr(1));
}

void save(Backend& backend, const Start& start, uint64_t step, Backend::State state, const std::string& file) {
  Checkpoint checkpoint{start.scene, backend.save(), step};
  checkpoint.scene.positions = std::move(state.positions);
  checkpoint.scene.velocities = std::move(state.velocities);
  write_checkpoint(file, checkpoint);
}

// Moves to the last step; returns the results of the last step, or of every step with --per-step.
std::vector<RunStep> simulate(Backend& backend, const RunOptions& options, const Start& start, CollideOptions collide) {
  std::vector<RunStep> results;
  Progress progress;
  const uint64_t end = start.step + options.steps;
  for (uint64_t step = start.step; step <= end; ++step) {
    if (step > start.step) backend.move();
    const bool last = step == end, collides = last || options.per_step;
    const bool periodic = options.save_every && step > start.step && step % options.save_every == 0;
    const bool saves = !options.save_file.empty() && (last || periodic);
    if (!collides && !saves) continue;
    Backend::State state = current_state(backend);
    require_finite(state, step);
    const uint64_t hash = state_hash(state.positions, state.velocities, state.wide);
    if (saves) save(backend, start, step, std::move(state), options.save_file);
    if (!collides) continue;
    progress.say(fmt::format("step {} of {}", step, end));
    collide.want_pairs = last && !options.pairs_file.empty();
    backend.collide(collide);
    const Collisions totals = backend.collisions();
    results.push_back({step, hash, totals});
  }
  return results;
}

void warn_of_stalled_spheres(const Scene& scene) {
  const uint64_t stalled = stalled_spheres(scene);
  if (stalled)
    fmt::print(stderr,
               "WARNING: {} spheres are too far from the origin for their speed: a step is less than half an ulp of "
               "their float32 position, so they do not move. Use --precision compensated or --motion anchored.\n",
               stalled);
}

json run_record(const CommandLine& line, const Session& session, const Start& start, const CollideOptions& collide,
                const MethodChoice& choice, const std::vector<RunStep>& results) {
  json steps = json::array();
  for (const RunStep& result : results) steps.push_back(to_json(result));
  return {{"context", capture_context(line.words)},
          {"backends", session.to_json()},
          {"scene", start.record},
          {"motion", motion_label(start.scene.motion)},
          {"dt", start.scene.dt},
          {"restitution", start.scene.restitution},
          {"method", method_name(choice.method)},
          {"choice", to_json(choice)},
          {"block", choice.block ? choice.block : collide.block},
          {"exact", collide.exact},
          {"swept", collide.swept},
          {"steps", steps}};
}

}  // namespace

int run_command(const CommandLine& line, const RunOptions& options) {
  require_known_backends({options.backend});
  if (options.save_every && options.save_file.empty())
    throw std::invalid_argument("--save-every needs a file name: --save FILE");
  check_files(options);
  const Start start = start_of(options.start, line.open.threads);
  const Scene& scene = start.scene;
  check_scene(scene);
  Session session({options.backend}, line.open);
  Backend& backend = *session.find(options.backend);
  const CollideOptions collide = collide_options(options, backend);
  for (const std::string& warning : session.warnings()) fmt::print(stderr, "{}\n", warning);
  if (options.steps) warn_of_stalled_spheres(scene);
  const std::string rounded =
      reach_warning(pairs_within_reach(backend, scene, start.rounding, collide), start.rounding);
  if (!rounded.empty()) fmt::print(stderr, "{}\n", wrap("At the start: " + rounded, 100, "  "));
  upload_start(start, backend);
  const std::vector<RunStep> results = simulate(backend, options, start, collide);
  const MethodChoice choice = backend.choice(collide);
  fmt::print("{}{} on {}: {}{}, scene {}, {} spheres, {} steps of {}\n", start.notes, options.backend,
             device_label(backend.info()), label({&backend, collide}),
             options.naive   ? " (naive)"
             : options.swept ? " (within the next step)"
                             : "",
             start.label, scene.size(), options.steps, motion_label(scene.motion));
  if (collide.method == Method::automatic) fmt::print("auto: {}\n", describe(choice));
  print_steps(results);
  if (!options.pairs_file.empty()) write_pairs(options.pairs_file, backend.pairs());
  if (!options.contacts_file.empty()) write_contact_numbers(options.contacts_file, backend.counts());
  if (!options.json_file.empty())
    write_file(options.json_file, json_text(run_record(line, session, start, collide, choice, results)));
  return kOk;
}

}  // namespace spherepair
