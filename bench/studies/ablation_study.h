// SPDX-License-Identifier: MIT
// The measurements of spherepair skips.
#pragma once

#include "bench/check/step_result.h"
#include "bench/measure/timing.h"
#include "bench/studies/ablation_list.h"

namespace spherepair {

struct AblateOptions {
  std::vector<std::string> backends, names;  // empty: all that open, all skips and api
  std::vector<uint64_t> sizes;               // empty: one that suits the machine
  double packing_fraction = 0.3;
  int rounds = 11;
  std::string json_file = "skips.json";
};

// Seconds of the host, by what for.
struct AblationSeconds {
  double opening = 0, uploading = 0, checking = 0, timing = 0;
};

class AblationStudy {
 public:
  // `written` is called after every row, so that nothing timed is lost.
  AblationStudy(Session& session, const OpenOptions& open, const AblateOptions& options, std::function<void()> written);

  void run(const std::vector<uint64_t>& sizes);

  std::vector<std::vector<std::string>> rows;  // of the table
  json measurements = json::array();
  std::vector<std::string> left_out;
  AblationSeconds spent;

 private:
  struct Turn {  // both ways of one skip on one backend
    const Ablation* ablation;
    Backend *on, *off;
  };

  std::vector<Turn> turns();
  const Scene& scene(Spheres kind);
  void hold(Backend& backend, Spheres kind);
  const StepResult& expected(Spheres kind);
  Configuration reference();
  void check(const Turn& turn);
  void check_sets(const Turn& turn);
  void check_moves(const Turn& turn);
  void take(Turn turn);
  void time(const Turn& turn);
  void record(const Turn& turn, const Contender& contender, const Samples& samples, bool on);

  Session& session_;
  OpenOptions open_;
  const AblateOptions& options_;
  std::function<void()> written_;
  Sampling sampling_;
  Progress progress_;
  SceneOptions scene_options_;
  std::map<Spheres, Scene> scenes_;            // of this size, made when first asked for
  std::map<Spheres, StepResult> expected_;     // of the reference
  std::map<const Backend*, Spheres> holding_;  // what each backend was given and has not moved on from
};

}  // namespace spherepair
