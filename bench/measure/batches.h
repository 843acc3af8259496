// SPDX-License-Identifier: MIT
// Times batches of back-to-back steps between full synchronisations: chooses the number of steps K, and takes turns.
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

// One of the ways that are timed against each other.
struct Contender {
  std::string label;
  Backend* backend;
  std::function<void(Backend&)> step;  // enqueues one step

  // Contenders that are compared have the same contest: they share K and take their turns one right after the other.
  // Empty: no comparison.
  std::string contest = {};

  // Enqueues this many steps in one go; empty: calls `step` that often.
  std::function<void(Backend&, uint64_t)> steps = {};

  bool alternates = false;  // others change the backend's state: an untimed step precedes each batch, also on the host

  // Called before each batch, untimed: brings the backend to the state in which all contenders of the contest begin.
  // For steps that change the work of later ones.
  std::function<void(Backend&)> restart = {};

  uint64_t batch = 0;        // the largest K; 0: chosen
  bool prepares = false;     // captures and allocations are part of its steps
  uint64_t working_set = 0;  // bytes that a step touches; 0: unknown
};

struct Sampling {
  int rounds = 11;                 // of every contender
  double fixed_share = 0.005;      // K is so large that the fixed cost is at most this share of the longest batch ...
  double longest = 0.25;           // ... unless that would take longer than this, in seconds
  double hardware_seconds = 2e-3;  // least duration of the longest batch on a GPU ...
  double software_seconds = 0.05;  // ... and on the host, GPU APIs in software included
  // On a GPU each batch follows an untimed batch with this share of the longest one's steps, which is waited for: in
  // OpenGL a batch after a long one is 1 to 2 ms late (docs/NOTES/measuring.md).
  double ahead = 0;
  uint64_t seed = 1;  // of all random orders
  Clocks clocks = host_clocks();
};

// Shuffles by Fisher-Yates with an integer hash: the same order on every machine.
template <typename T>
void shuffle(std::vector<T>& order, uint64_t& state) {
  for (size_t left = order.size(); left > 1; --left) {
    state = splitmix64(state);
    std::swap(order[left - 1], order[state % left]);
  }
}

struct Batch {
  double seconds = 0, cores = 0;  // cores: busy cores of this process
  double enqueuing = 0;           // seconds until the last step was enqueued, before the wait
  Preparations prepared;          // inside the batch
};

// Times a batch; the device is idle before and after. `ahead` untimed steps follow the restart. On a GPU there are
// three, so that neither the switch from another API's work nor the capture of a graph is timed. With a restart there
// are three everywhere, so that all contenders start alike.
Batch time_batch(const Contender& contender, uint64_t steps, int ahead, const Clocks& clocks);
int steps_ahead(const Contender& contender, uint64_t largest);

// The steps of each batch of a turn, for contenders that share K: K/4, K/2 and K, or only K if it is below 4.
struct BatchPlan {
  std::vector<uint64_t> steps;
  bool bounded = false;  // Sampling::longest limits K: the fixed cost may have a larger share
  double ahead = 0;      // as Sampling::ahead
};
BatchPlan plan_batches(std::span<const Contender* const> contenders, const Sampling& sampling);

struct Turn {
  std::vector<double> seconds;  // of each batch, in the order of the plan's steps
  double cores = 0;             // of the longest batch
  uint64_t retaken = 0;         // batches taken again because something was prepared in them
  Preparations prepared = {};   // counts of a contender that prepares
};
// Takes the batches in random order. Throws BackendError that names the contender if something is prepared inside a
// batch three times in a row.
Turn take_turn(const Contender& contender, const BatchPlan& plan, const Clocks& clocks, uint64_t& order);

// Fits t(K) = fixed + step K to the batches of all rounds by the least sum of absolute deviations (Boscovich 1757),
// since late batches would bend a line of least squares. None if longer batches took no longer than shorter ones.
struct Fit {
  double step, fixed;  // seconds
};
std::optional<Fit> fit(std::span<const uint64_t> steps, std::span<const std::vector<double>> rounds);

}  // namespace spherepair
