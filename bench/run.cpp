// SPDX-License-Identifier: MIT
// spherepair run
#include <fmt/format.h>

#include "answers.h"
#include "arguments.h"
#include "choice.h"
#include "commands.h"
#include "context.h"
#include "files.h"

namespace spherepair {
namespace {

struct StepResult {
  uint64_t step, state;
  Collisions totals;
};

CollideOptions collide_options(const RunOptions& options, const Backend& backend, uint64_t n) {
  CollideOptions collide;
  collide.method = choose_method(options.method, backend, n);
  collide.block = parse_blocks({options.block}).front();
  collide.exact = !options.naive;
  return collide;
}

std::string pairs_text(const std::vector<Pair>& pairs) {
  fmt::memory_buffer text;
  for (const Pair& pair : pairs) fmt::format_to(std::back_inserter(text), "{} {}\n", pair.first, pair.second);
  return fmt::to_string(text);
}

json to_json(const StepResult& result) {
  const Collisions& totals = result.totals;
  return {{"step", result.step},
          {"pairs", totals.pairs},
          {"colliding_spheres", totals.colliding_spheres},
          {"fingerprint", hex64(totals.fingerprint.a) + hex64(totals.fingerprint.b)},
          {"state", hex64(result.state)},
          {"deferred", totals.deferred},
          {"decided_by_stage", totals.decided_by}};
}

void print_steps(const std::vector<StepResult>& results) {
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

// Steps, and the results of those that are asked for.
std::vector<StepResult> simulate(Backend& backend, const RunOptions& options, CollideOptions collide) {
  std::vector<StepResult> results;
  Progress progress;
  for (uint64_t step = 0; step <= options.steps; ++step) {
    if (step > 0) backend.move();
    const bool last = step == options.steps;
    if (!last && !options.per_step) continue;
    progress.say(fmt::format("step {} of {}", step, options.steps));
    collide.want_pairs = last && !options.pairs_file.empty();
    backend.collide(collide);
    const Collisions totals = backend.collisions();
    const Backend::State state = backend.state();
    results.push_back({step, state_hash(state.positions, state.velocities), totals});
  }
  return results;
}

}  // namespace

int run_command(const CommandLine& line, const RunOptions& options) {
  require_known_backends({options.backend});
  const auto [scene, scene_name, notes, record] = start_of(options.start, line.open.threads);
  check_scene(scene);
  Session session({options.backend}, line.open);
  Backend& backend = *session.find(options.backend);
  const CollideOptions collide = collide_options(options, backend, scene.size());
  for (const std::string& warning : session.warnings()) fmt::print(stderr, "{}\n", warning);
  backend.upload(scene);
  const std::vector<StepResult> results = simulate(backend, options, collide);
  fmt::print("{}{} on {}: {}{}, scene {}, {} spheres, {} steps\n", notes, options.backend, device_label(backend.info()),
             label({&backend, collide}), options.naive ? " (naive)" : "", scene_name, scene.size(), options.steps);
  print_steps(results);
  if (!options.pairs_file.empty()) write_file(options.pairs_file, pairs_text(backend.pairs()));
  if (options.json_file.empty()) return kOk;
  json steps = json::array();
  for (const StepResult& result : results) steps.push_back(to_json(result));
  write_file(options.json_file, json_text({{"context", capture_context(line.words)},
                                           {"backends", session.to_json()},
                                           {"scene", record},
                                           {"method", method_name(collide.method)},
                                           {"block", collide.block},
                                           {"exact", collide.exact},
                                           {"steps", steps}}));
  return kOk;
}

}  // namespace spherepair
