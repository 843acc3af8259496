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
#include "bench/measure/run_times.h"
#include "bench/spheres/pair_file.h"
#include "bench/spheres/sphere_output.h"
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
  files.write("--json", options.json_file);
  check_pair_file("--pairs", options.pairs_file);
  check_pair_file("--contacts", options.contacts_file);
  check_sphere_output("--spheres", options.spheres_file);
}

struct RunStep {
  uint64_t step, state;
  Collisions totals;
};

CollideOptions collide_options(const RunOptions& options, Backend& backend) {
  CollideOptions collide;
  collide.swept = options.swept;
  const bool swept_by_default = options.swept && options.method.empty();
  collide.method = swept_by_default ? swept_method(backend) : choose_method(options.method, backend);
  if (options.block) collide.block = require_groups({&backend, collide}, parse_blocks({options.block}).front());
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

std::string steps_text(const std::vector<RunStep>& results) {
  Table table{"",
              {{"", "step", ""},
               {"", "pairs", ""},
               {"", "colliding", "spheres"},
               {"", "fingerprint of the pairs", "", true},
               {"", "hash of the state", "", true}},
              {},
              {}};
  for (const auto& [step, state, totals] : results)
    table.rows.push_back({std::to_string(step), std::to_string(totals.pairs), std::to_string(totals.colliding_spheres),
                          hex64(totals.fingerprint.a) + hex64(totals.fingerprint.b), hex64(state)});
  return table.text().substr(1);
}

void save(Backend& backend, const Start& start, uint64_t step, Backend::State state, const std::string& file) {
  Checkpoint checkpoint{start.scene, backend.save(), step};
  checkpoint.scene.positions = std::move(state.positions);
  checkpoint.scene.velocities = std::move(state.velocities);
  write_checkpoint(file, checkpoint);
}

// Moves to the last step; keeps the results of the last step, or of every step with --per-step.
class Run {
 public:
  Run(Backend& backend, const RunOptions& options, const Start& start, const CollideOptions& collide, RunTimes& times)
      : backend_(backend),
        options_(options),
        start_(start),
        collide_(collide),
        times_(times),
        step_(start.step),
        end_(start.step + options.steps) {}

  std::vector<RunStep> simulate() {
    if (options_.steps == 0) return time_last([&] { stand(); });
    stand();
    while (step_ + 1 < end_) {
      move_to(next_stop());
      stand();
    }
    return time_last([&] {
      move_to(end_);
      stand();
    });
  }

 private:
  // The last step is done between timers, kernel by kernel. In software OpenGL's would stop before the work does.
  template <typename Work>
  std::vector<RunStep> time_last(Work work) {
    const bool timers = backend_.info().device_timers || backend_.info().on_host;
    backend_.time_stages(timers);
    work();
    if (timers) times_.set_stages(backend_, backend_.stage_times());
    backend_.time_stages(false);
    return std::move(results_);
  }

  // The next step after which there is something to do.
  uint64_t next_stop() const {
    if (options_.per_step) return step_ + 1;
    const uint64_t every = options_.save_every;
    return every ? std::min(end_ - 1, (step_ / every + 1) * every) : end_ - 1;
  }

  // On a GPU moves are enqueued: they take until the wait.
  void move_to(uint64_t stop) {
    times_.count(RunTimes::moves, stop - step_);
    times_.spend(RunTimes::moves, [&] {
      while (step_ < stop) {
        backend_.move();
        ++step_;
        if (!progress_.due()) continue;
        backend_.finish();
        progress_.reach(step_ - start_.step, options_.steps);
        progress_.say("moving");
      }
      backend_.finish();
    });
  }

  // What is to be done where the spheres now stand.
  void stand() {
    const bool last = step_ == end_, collides = last || options_.per_step;
    const bool periodic = options_.save_every && step_ > start_.step && step_ % options_.save_every == 0;
    const bool saves = !options_.save_file.empty() && (last || periodic);
    if (!collides && !saves) return;
    RunStep result{step_, 0, {}};
    times_.count(RunTimes::states, 1);
    times_.spend(RunTimes::states, [&] {
      Backend::State state = current_state(backend_);
      require_finite(state, step_);
      result.state = state_hash(state.positions, state.velocities, state.wide);
      if (saves) save(backend_, start_, step_, std::move(state), options_.save_file);
    });
    if (!collides) return;
    collide_.want_pairs = last && !options_.pairs_file.empty();
    times_.count(RunTimes::searches, 1);
    times_.spend(RunTimes::searches, [&] { backend_.collide(collide_); });
    result.totals = backend_.collisions();
    results_.push_back(result);
  }

  Backend& backend_;
  const RunOptions& options_;
  const Start& start_;
  CollideOptions collide_;
  RunTimes& times_;
  uint64_t step_, end_;
  Progress progress_;
  std::vector<RunStep> results_;
};

json run_record(const CommandLine& line, const ChosenBackend& chosen, const Start& start, const CollideOptions& collide,
                const MethodChoice& choice, const std::vector<RunStep>& results, const RunTimes& times) {
  return {{"context", capture_context(line.words)},
          {"backends", chosen.session->to_json()},
          {"passed_over", chosen.passed_over},
          {"scene", start.record},
          {"motion", motion_label(start.scene.motion)},
          {"dt", start.scene.dt},
          {"restitution", start.scene.restitution},
          {"plane", start.scene.plane},
          {"contacts", to_json(start.scene.contact)},
          {"method", method_name(choice.method)},
          {"choice", to_json(choice)},
          {"block", choice.block ? choice.block : collide.block},
          {"exact", collide.exact},
          {"swept", collide.swept},
          {"times", times.to_json()},
          {"steps", list_of(results)}};
}

std::string heading(const RunOptions& options, const ChosenBackend& chosen, const Start& start,
                    const CollideOptions& collide) {
  const Backend& backend = *chosen.backend;
  const std::string what = fmt::format("{} on {}: {}{}, scene {}, {}, {} of {}", backend.info().name,
                                       device_label(backend.info()), label({chosen.backend, collide}),
                                       options.naive   ? " (naive)"
                                       : options.swept ? " (within the next step)"
                                                       : "",
                                       start.label, counted(start.scene.size(), "sphere"),
                                       counted(options.steps, "step"), motion_label(start.scene.motion));
  std::string text = start.notes + wrapped(what, "", "  ") + "\n" + passed_over_text(chosen);
  if (options.steps) text += plane_text(start.scene) + describe_contacts(start.scene);
  if (collide.method == Method::automatic)
    text += wrapped("auto: " + describe(backend.choice(collide)), "", "  ") + "\n";
  return text;
}

}  // namespace

int run_command(const CommandLine& line, const RunOptions& options) {
  if (options.save_every && options.save_file.empty())
    throw std::invalid_argument("--save-every needs a file name: --save FILE");
  check_files(options);
  RunTimes times;
  const Start start = times.spend(RunTimes::spheres, [&] { return start_of(options.start, line.open.threads); });
  check_scene(start.scene);
  const ChosenBackend chosen =
      times.spend(RunTimes::opening, [&] { return choose_backend(options.backend, line.open, line.opener); });
  Backend& backend = *chosen.backend;
  const CollideOptions collide = collide_options(options, backend);
  for (const std::string& warning : chosen.session->warnings()) fmt::print(stderr, "{}\n", warning);
  if (options.steps) fmt::print(stderr, "{}", stalled_warning(start.scene));
  if (!options.spheres_file.empty()) fmt::print(stderr, "{}", species_warning(start));
  const std::string rounded =
      reach_warning(pairs_within_reach(backend, start.scene, start.rounding, collide), start.rounding);
  if (!rounded.empty()) fmt::print(stderr, "{}\n", wrapped("At the start: " + rounded, "* ", "  "));
  times.spend(RunTimes::opening, [&] { upload_start(start, backend); });
  const std::vector<RunStep> results = Run(backend, options, start, collide, times).simulate();
  if (!options.pairs_file.empty()) write_pairs(options.pairs_file, backend.pairs());
  if (!options.contacts_file.empty()) write_contact_numbers(options.contacts_file, backend.counts());
  if (!options.spheres_file.empty()) {
    const Backend::State state = current_state(backend);
    write_spheres(options.spheres_file, state.positions, state.velocities);
  }
  const bool taken =
      is_standard_output({options.pairs_file, options.contacts_file, options.spheres_file, options.json_file});
  std::FILE* report = taken ? stderr : stdout;
  fmt::print(report, "{}{}{}", heading(options, chosen, start, collide), steps_text(results), times.text());
  write_json(options.json_file, run_record(line, chosen, start, collide, backend.choice(collide), results, times));
  return kOk;
}

}  // namespace spherepair
