// SPDX-License-Identifier: MIT
// A backend whose steps take a known time on the test's own clock, and a session and sampling for it.
#pragma once

#include <map>

#include "api/open.h"
#include "bench/measure/timing.h"
#include "tests/support/forwarding_backend.h"

namespace spherepair {

// Seconds in place of the host's clocks: only a step or a wait advances them.
struct TestClock {
  double wall = 0, cores = 0;
  double others = 0;  // share of the machine's cores that other programs keep busy
  static constexpr int machine_cores = 4;
  Clocks clocks() {
    return {[this] { return wall; }, [this] { return cores; },
            [this] {
              return MachineUse{1 + cores + others * machine_cores * wall, machine_cores};
            }};
  }
};

// Acts as a GPU, unless its name is cpu. A batch takes `fixed` seconds for the wait at its end and `step` for each
// step. After a batch of more than `many` steps it takes `late` more, unless it has at most `few` itself.
class ClockedBackend final : public ForwardingBackend {
 public:
  ClockedBackend(const std::string& name, TestClock& clock)
      : ForwardingBackend(name, open_backend("cpu", {.threads = 1})), clock_(clock) {
    info_.software = false;
  }
  void run_step() {
    clock_.wall += step + drift * double(steps);
    clock_.cores += busy * step;
    ++steps;
    if (capture_every && steps % capture_every == 0) ++prepared.captures;
  }
  void finish() override {
    const uint64_t submitted = steps - waited_for_;
    waited_for_ = steps, clock_.wall += fixed;
    if (submitted <= few) return;
    if (behind_many_) clock_.wall += late;
    behind_many_ = submitted > many;
  }
  Preparations preparations() const override { return prepared; }
  void launch_empty(uint) override { ++empty_launches, times_.push_back({"empty", 5e-6}); }
  void time_stages(bool on) override { timing_ = on, times_.clear(); }
  std::vector<StageTime> stage_times() override { return times_; }
  // Two kernels, the second launched twice; each launch takes longer from step to step.
  void run_stages() {
    if (!timing_) return;
    const double longer = drift * double(steps);
    times_.insert(times_.end(),
                  {{"clear", 4e-6 + longer}, {"collide_grid", 50e-6 + longer}, {"collide_grid", 50e-6 + longer}});
  }
  BackendInfo& facts() { return info_; }

  static constexpr uint64_t few = 3, many = 100;
  double step = 1e-5, fixed = 0, drift = 0, busy = 1, late = 0;
  uint64_t steps = 0, capture_every = 0, empty_launches = 0;
  Preparations prepared;

 private:
  TestClock& clock_;
  uint64_t waited_for_ = 0;
  bool timing_ = false, behind_many_ = false;
  std::vector<StageTime> times_;
};

// The CPU, GLSL and CUDA of a test.
struct ClockedSession {
  explicit ClockedSession(const std::vector<std::string>& names = {"cpu", "opengl", "cuda"})
      : session(names, {}, [this](const std::string& name, const OpenOptions&) {
          auto made = std::make_unique<ClockedBackend>(name, clock);
          backends[name] = made.get();
          return made;
        }) {
    sampling.clocks = clock.clocks();
  }
  ClockedBackend& operator[](const std::string& name) { return *backends.at(name); }
  Contender contender(const std::string& name, const std::string& contest = {}) {
    return {.label = name + " steps",
            .backend = &(*this)[name],
            .step = [](Backend& each) { static_cast<ClockedBackend&>(each).run_step(); },
            .contest = contest};
  }
  std::vector<Samples> measure(const std::vector<Contender>& contenders) {
    return spherepair::measure(session, contenders, sampling, progress);
  }

  TestClock clock;
  std::map<std::string, ClockedBackend*> backends;
  Session session;
  Sampling sampling;
  Progress progress;
};

}  // namespace spherepair
