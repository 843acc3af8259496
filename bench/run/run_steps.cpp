// SPDX-License-Identifier: MIT
#include "bench/run/run_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/check/finite_state.h"
#include "bench/io/interruption.h"
#include "bench/run/run_files.h"
#include "common/files/checkpoint.h"

namespace spherepair {
namespace {

constexpr uint64_t steps_between_looks = 1000;  // for --until-rest

void save(Motion& motion, const Start& start, uint64_t step, const Motion::State& state, const std::string& file) {
  Checkpoint checkpoint{start.scene, motion.save(), step};
  checkpoint.scene.positions = state.positions;
  checkpoint.scene.velocities = state.velocities;
  write_checkpoint(file, checkpoint);
}

}  // namespace

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

bool Run::finds_contacts() const {
  return start_.scene.contact.law != ContactLaw::none && collide_.exact && !collide_.swept &&
         collide_.method != Method::collide_group;
}

std::vector<RunStep> Run::simulate() {
  if (step_ == end_) return time_last([&] { stand(); });
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

// Times the last step kernel by kernel. Not in software OpenGL, whose timers stop before the work does.
template <typename Work>
std::vector<RunStep> Run::time_last(Work work) {
  const bool timers = backend_.info().device_timers || backend_.info().on_host;
  backend_.time_stages(timers);
  work();
  if (timers) times_.set_stages(backend_, backend_.stage_times());
  backend_.time_stages(false);
  return std::move(results_);
}

// The next step at which the run searches, writes, looks for rest or ends.
uint64_t Run::next_stop() const {
  if (options_.per_step) return step_ + 1;
  uint64_t stop = end_ - 1;
  for (const uint64_t every : {options_.save_every, statistics_every(), trajectory_every()})
    if (every) stop = std::min(stop, (step_ / every + 1) * every);
  if (options_.until_rest) {  // looks at two consecutive steps
    const uint64_t look = (step_ / steps_between_looks + 1) * steps_between_looks;
    stop = std::min(stop, step_ + 1 < look ? look - 1 : look);
  }
  return stop;
}

// Moves to this step. On a GPU moves are enqueued, so their time includes the wait.
void Run::move_to(uint64_t stop) {
  times_.spend(RunTimes::moves, [&] {
    while (step_ < stop) {
      backend_.move();
      times_.count(RunTimes::moves, 1);
      ++step_;
      if (!progress_.due()) continue;
      backend_.finish();
      if (!options_.until_rest) progress_.reach(step_ - start_.step, end_ - start_.step);
      progress_.say(options_.until_rest ? fmt::format("moving: step {}", step_) : "moving");
    }
    backend_.finish();
  });
}

// Compares the states of two consecutive steps. If they are equal, no later step changes anything, and the run ends
// with the next step.
void Run::look_for_rest(uint64_t state) {
  if (seen_ && seen_->step + 1 == step_) {
    summary_.at_rest = seen_->state == state;
    if (*summary_.at_rest && step_ < end_ && step_ % steps_between_looks == 0) end_ = step_ + 1;
  }
  seen_ = {step_, state, {}};
}

void Run::summarize(const Motion::State& state) {
  summary_.step = step_;
  summary_.seconds = double(step_) * double(start_.scene.dt);
  for (const vec4& v : state.velocities)
    summary_.greatest_speed = std::max(summary_.greatest_speed, std::hypot(double(v.x), double(v.y), double(v.z)));
}

// Searches, measures and writes at the current step, as the options ask.
void Run::stand() {
  const bool last = step_ == end_, wanted = last || options_.per_step, measures = is_due(statistics_every());
  const bool counts = measures || (last && finds_contacts()), frames = is_due(trajectory_every());
  const bool periodic = options_.save_every && step_ > start_.step && step_ % options_.save_every == 0;
  const bool saves = !options_.save_file.empty() && (last || periodic);
  const bool looks = start_.scene.contact.drag > 0 &&
                     (step_ + 1 >= end_ || (options_.until_rest && (step_ + 1) % steps_between_looks <= 1));
  if (!wanted && !measures && !frames && !saves && !looks) return;
  Motion::State state;
  RunStep result{step_, 0, {}};
  times_.count(RunTimes::states, 1);
  times_.spend(RunTimes::states, [&] {
    state = current_state(backend_);
    require_finite(state, step_);
    result.state = state_hash(state.positions, state.velocities, state.wide);
  });
  if (looks) look_for_rest(result.state);
  if (wanted || counts) {
    collide_.want_pairs = counts || (last && !options_.pairs_file.empty());
    times_.count(RunTimes::searches, 1);
    times_.spend(RunTimes::searches, [&] { backend_.collide(collide_); });
    result.totals = backend_.collisions();
  }
  if (last) summarize(state);
  if (counts) summary_.contacts = contact_statistics(start_.scene, state.wide, backend_.pairs(), step_);
  if (measures) {
    statistics_.push_back(*summary_.contacts);
    const std::string row = statistics_row(statistics_.back());
    table_.add(statistics_.size() == 1 ? first_rows(options_, start_, row, most_) : row);
  }
  if (frames) trajectory_.add(trajectory_frame(start_.scene, state, step_));
  if (saves) {
    save(backend_, start_, step_, state, options_.save_file);
    note_resumable(fmt::format("{} is of step {}; go on with\n  {}", options_.save_file, step_,
                               command_to_go_on(options_, step_, most_)));
  }
  if (wanted) results_.push_back(result);
}

}  // namespace spherepair
