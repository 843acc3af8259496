// SPDX-License-Identifier: MIT
// Batches of back-to-back steps between full synchronisations: how many steps K, and what a turn of them takes.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bench/io/machine_load.h"
#include "common/backend/backend.h"
#include "common/shared/hash.h"

namespace spherepair {

// What is timed against others.
struct Contender {
  std::string label;
  Backend* backend;
  std::function<void(Backend&)> step;  // enqueues one step

  // Those that are compared are in a contest: they share K and take their turns in a row. Empty: it is alone.
  std::string contest = {};

  // Enqueues so many in one go; empty: `step` as often.
  std::function<void(Backend&, uint64_t)> steps = {};

  bool alternates = false;  // others change the backend's state: a step goes ahead, also on the host

  // Called before each batch, untimed: brings the backend to the state in which all of the contest begin. For steps
  // that change the work of the next ones.
  std::function<void(Backend&)> restart = {};

  uint64_t batch = 0;        // the largest K; 0: chosen
  bool prepares = false;     // captures and allocations are part of its steps
  uint64_t working_set = 0;  // bytes that a step touches; 0: not known
};

struct Sampling {
  int rounds = 11;             // of every contender
  double fixed_share = 0.005;  // K is so large that a sample's fixed cost is no larger share of the longest batch ...
  double longest = 0.25;       // ... unless that would take longer than this, in seconds
  double hardware_seconds = 2e-3;  // least duration of the longest batch on a GPU ...
  double software_seconds = 0.05;  // ... and on the host, GPU APIs in software included
  // Ahead of each batch on a GPU one of this share of the longest one's steps is taken, waited for and not timed: in
  // OpenGL the batch behind a long one is 1 to 2 ms late (docs/NOTES/measuring.md).
  double ahead = 0;
  uint64_t seed = 1;  // of every order
  Clocks clocks = host_clocks();
};

// Fisher-Yates with an integer hash: the same order on every machine.
template <typename T>
void shuffle(std::vector<T>& order, uint64_t& state) {
  for (size_t left = order.size(); left > 1; --left) {
    state = splitmix64(state);
    std::swap(order[left - 1], order[state % left]);
  }
}

struct Batch {
  double seconds = 0, cores = 0;  // cores: that this process kept busy meanwhile
  double enqueuing = 0;           // seconds until the last step was enqueued, before the wait
  Preparations prepared;          // inside of the batch
};

// From and to an idle device. Untimed steps go ahead, behind the restart: three on a GPU, so that neither the switch
// from another API's work nor the capture of a graph is timed, and wherever there is a restart, so that all start
// alike.
Batch time_batch(const Contender& contender, uint64_t steps, int ahead, const Clocks& clocks);
int steps_ahead(const Contender& contender, uint64_t largest);

// K of each batch of a turn: K/4, K/2 and K, or one below 4. Of contenders that share K.
struct BatchPlan {
  std::vector<uint64_t> steps;
  bool bounded = false;  // by Sampling::longest: the fixed cost may have a larger share
  double ahead = 0;      // as Sampling::ahead
};
BatchPlan plan_batches(std::span<const Contender* const> contenders, const Sampling& sampling);

struct Turn {
  std::vector<double> seconds;  // as the plan's steps
  double cores = 0;             // of the longest batch
  uint64_t retaken = 0;         // batches, since something was prepared in them
  Preparations prepared = {};   // of a contender that prepares
};
// The batches in random order. Throws BackendError that names the contender when something is prepared inside of one
// three times in a row.
Turn take_turn(const Contender& contender, const BatchPlan& plan, const Clocks& clocks, uint64_t& order);

// t(K) = fixed + step K through the batches of all rounds, by the least sum of absolute deviations (Boscovich 1757),
// since some batches are late and would bend a line by least squares. None where longer batches took no longer than
// shorter ones.
struct Fit {
  double step, fixed;  // seconds
};
std::optional<Fit> fit(std::span<const uint64_t> steps, std::span<const std::vector<double>> rounds);

}  // namespace spherepair
