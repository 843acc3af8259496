// SPDX-License-Identifier: MIT
// The rows of Google Benchmark: everything that the open backends can do; each is checked, then timed.
#pragma once

#include <map>

#include "bench/tables/study.h"

namespace spherepair {

// One benchmark of one backend.
struct BenchRow {
  std::string name;  // opengl/collide_tiled/128, cuda/move, cpu/step, opengl/empty
  Backend* backend;
  std::optional<Work> work;  // none: an empty kernel
  CollideOptions options;
};

// Every backend's motion, whole step and empty kernel, and all_configurations() at these group sizes.
std::vector<BenchRow> bench_rows(Session& session, const std::vector<uint>& blocks);

// The parameters of a row that are not numbers, and so not counters, as `name=value` words.
std::string parameters_of(const BenchRow& row, const SceneOptions& scene);

// The scene of the rows.
class BenchScene {
 public:
  BenchScene(Session& session, const SceneOptions& options)
      : session_(session), options_(options), scene_(make_scene(options)) {}

  // Compares the row's result with the reference's, once; throws DifferenceFound. Returns the batches of a turn.
  const BatchPlan& check(const BenchRow& row, const Sampling& sampling);

  // Uploads the scene and returns seconds per step of a turn.
  double sample(const BenchRow& row, const BatchPlan& plan, const Sampling& sampling);

  const SceneOptions& options() const { return options_; }

 private:
  void check_result(const BenchRow& row);
  void check_motion(const BenchRow& row);
  Contender contender_for(const BenchRow& row);

  Session& session_;
  SceneOptions options_;
  Scene scene_;
  std::map<std::string, BatchPlan> plans_;  // of the checked rows
  uint64_t order_ = 1;                      // of the batches
};

}  // namespace spherepair
