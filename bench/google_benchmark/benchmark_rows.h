// SPDX-License-Identifier: MIT
// The rows of Google Benchmark: everything that the open backends can do; each is checked, then timed.
#pragma once

#include <map>

#include "bench/tables/study.h"

namespace spherepair {

// One benchmark of one backend.
struct BenchRow {
  std::string name;  // glsl/collide_tiled/128, cuda/move, cpu/step, glsl/empty
  Backend* backend;
  std::optional<Work> work;  // none: an empty kernel
  CollideOptions options;
};

// Every backend's motion, whole step and empty kernel, and all_configurations() at these group sizes.
std::vector<BenchRow> bench_rows(Session& session, const std::vector<uint>& blocks);

// The parameters of a row that are not numbers, and so not counters, as `name=value` words.
std::string parameters_of(const BenchRow& row, const SceneOptions& scene);

class BenchScene;
using OnBackend = std::map<const Backend*, const BenchScene*>;  // the scene that each backend holds unmoved

// The scene of the rows; uploaded again if a row has moved it or another scene has replaced it.
class BenchScene {
 public:
  BenchScene(Session& session, const SceneOptions& options, OnBackend& on_backend);

  // Compares the row's result with the reference's, once; throws DifferenceFound. Returns K, the steps of a sample.
  uint64_t check(const BenchRow& row, const Sampling& sampling);

  // Seconds per step of K back-to-back steps.
  double sample(const BenchRow& row, uint64_t batch);

  const SceneOptions& options() const { return options_; }

 private:
  void restore(Backend& backend);
  void check_result(const BenchRow& row);
  void check_motion(const BenchRow& row);

  Session& session_;
  SceneOptions options_;
  Scene scene_;
  OnBackend& on_backend_;
  std::map<std::string, uint64_t> batches_;  // of the checked rows
};

}  // namespace spherepair
