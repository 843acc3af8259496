// SPDX-License-Identifier: MIT
// The measurements of spherepair launches.
#pragma once

#include "bench/check/step_result.h"
#include "bench/gpu/launch_paths.h"
#include "bench/measure/timing.h"

namespace spherepair {

struct LaunchesOptions {
  std::vector<std::string> backends = {};  // empty: all that open
  std::vector<uint64_t> sizes = {};        // empty: by machine
  int rounds = 11;
  std::string results = {};  // folder; empty: a new one
};

class LaunchStudy {
 public:
  // Calls `write` after every size of a work, so that an interrupted run keeps its measurements.
  LaunchStudy(Session& session, const LaunchesOptions& options, std::function<void()> write);

  void run(const std::vector<uint64_t>& sizes);

  json measurements = json::array();
  std::map<LaunchWork, std::vector<std::vector<std::string>>> rows;  // of the table of each work
  std::vector<std::string> left_out;

 private:
  struct Row {
    const LaunchPath* path;
    Backend* backend;
    json work_per_step;
    double each(const char* count) const { return work_per_step.at(count); }
  };

  void measure_size(LaunchWork work, uint64_t n);
  std::vector<Row> rows_of(LaunchWork work) const;
  void expect(LaunchWork work, const Scene& scene);
  bool check(Row& row, LaunchWork work, const Scene& scene, const SceneOptions& options);
  void require_reference(const Row& row, LaunchWork work, const SceneOptions& options);
  Contender contender_for(const Row& row, LaunchWork work, const Scene& scene) const;
  double enqueuing(const Contender& contender) const;
  void time(const std::vector<Row>& paths, LaunchWork work, const Scene& scene, const SceneOptions& options);
  void record(const Row& row, LaunchWork work, const SceneOptions& options, const Samples& samples, double enqueuing);

  Session& session_;
  std::function<void()> write_;
  Sampling sampling_;
  Progress progress_;
  StepResult expected_;           // the reference's result at this size ...
  Motion::State expected_state_;  // ... and its state, if spheres move
};

}  // namespace spherepair
