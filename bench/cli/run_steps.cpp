// SPDX-License-Identifier: MIT
#include "bench/cli/run_steps.h"

#include <algorithm>

#include "bench/check/finite_state.h"
#include "bench/formats/checkpoint.h"

namespace spherepair {
namespace {

void save(Backend& backend, const Start& start, uint64_t step, Backend::State state, const std::string& file) {
  Checkpoint checkpoint{start.scene, backend.save(), step};
  checkpoint.scene.positions = std::move(state.positions);
  checkpoint.scene.velocities = std::move(state.velocities);
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

std::vector<RunStep> Run::simulate() {
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

// The last step is done between timers, kernel by kernel. In software OpenGL's would stop before the work does.
template <typename Work>
std::vector<RunStep> Run::time_last(Work work) {
  const bool timers = backend_.info().device_timers || backend_.info().on_host;
  backend_.time_stages(timers);
  work();
  if (timers) times_.set_stages(backend_, backend_.stage_times());
  backend_.time_stages(false);
  return std::move(results_);
}

// The next step after which there is something to do.
uint64_t Run::next_stop() const {
  if (options_.per_step) return step_ + 1;
  uint64_t stop = end_ - 1;
  for (const uint64_t every : {options_.save_every, statistics_every()})
    if (every) stop = std::min(stop, (step_ / every + 1) * every);
  return stop;
}

// On a GPU moves are enqueued: they take until the wait.
void Run::move_to(uint64_t stop) {
  times_.spend(RunTimes::moves, [&] {
    while (step_ < stop) {
      backend_.move();
      times_.count(RunTimes::moves, 1);
      ++step_;
      if (!progress_.due()) continue;
      backend_.finish();
      progress_.reach(step_ - start_.step, options_.steps);
      progress_.say("moving");
    }
    backend_.finish();
  });
}

// Searches, measures and saves at the current step, as far as the options ask for it.
void Run::stand() {
  const bool last = step_ == end_, wanted = last || options_.per_step;
  const uint64_t each = statistics_every();
  const bool measures = each && (last || step_ == start_.step || step_ % each == 0);
  const bool periodic = options_.save_every && step_ > start_.step && step_ % options_.save_every == 0;
  const bool saves = !options_.save_file.empty() && (last || periodic);
  if (!wanted && !measures && !saves) return;
  Backend::State state;
  RunStep result{step_, 0, {}};
  times_.count(RunTimes::states, 1);
  times_.spend(RunTimes::states, [&] {
    state = current_state(backend_);
    require_finite(state, step_);
    result.state = state_hash(state.positions, state.velocities, state.wide);
  });
  if (wanted || measures) {
    collide_.want_pairs = measures || (last && !options_.pairs_file.empty());
    times_.count(RunTimes::searches, 1);
    times_.spend(RunTimes::searches, [&] { backend_.collide(collide_); });
    result.totals = backend_.collisions();
  }
  if (measures) {
    statistics_.push_back(contact_statistics(start_.scene, state.wide, backend_.pairs(), step_));
    table_.add((statistics_.size() == 1 ? statistics_heading() : "") + statistics_row(statistics_.back()));
  }
  if (saves) save(backend_, start_, step_, std::move(state), options_.save_file);
  if (wanted) results_.push_back(result);
}

}  // namespace spherepair
