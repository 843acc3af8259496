// SPDX-License-Identifier: MIT
// The measurements of spherepair ablate.
#pragma once

#include "bench/check/step_result.h"
#include "bench/measure/timing.h"
#include "bench/studies/ablation_list.h"

namespace spherepair {

struct AblateOptions {
  std::vector<std::string> backends, names;  // empty: all that open; all ablations
  std::vector<uint64_t> sizes;               // empty: by machine
  double packing_fraction = 0.3;
  int rounds = 11;
  std::string results;  // folder; empty: a new one
};

class AblationStudy {
 public:
  // Calls `write` after every row, so that an interrupted run keeps its measurements.
  AblationStudy(Session& session, const OpenOptions& open, const AblateOptions& options, std::function<void()> write);

  void run(const std::vector<uint64_t>& sizes);

  std::map<uint64_t, std::vector<std::vector<std::string>>> rows;  // of the table for each number of spheres
  json measurements = json::array();
  std::vector<std::string> left_out;

 private:
  struct Case {  // one ablation on one backend, on and off
    const Ablation* ablation;
    Backend *on, *off;
  };

  std::vector<Case> cases();
  const Scene& scene(Spheres kind);
  void hold(Backend& backend, Spheres kind);
  const StepResult& expected(Spheres kind);
  Configuration reference();
  void check(const Case& which);
  void check_sets(const Case& which);
  void check_moves(const Case& which);
  void run(Case which);
  Contender contender_for(const Case& which, const std::string& label, bool on);
  void time(const Case& which);
  void record(const Case& which, const Contender& contender, const Samples& samples, bool on);

  Session& session_;
  OpenOptions open_;
  const AblateOptions& options_;
  std::function<void()> write_;
  Sampling sampling_;
  Progress progress_;
  SceneOptions scene_options_;
  std::map<Spheres, Scene> scenes_;            // of the current size, made on first use
  std::map<Spheres, StepResult> expected_;     // the reference's results
  std::map<const Backend*, Spheres> holding_;  // the unmoved spheres that each backend holds
};

}  // namespace spherepair
