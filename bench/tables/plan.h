// SPDX-License-Identifier: MIT
// The plan of a compare run: sizes, scenes, methods, tables, sampling. Defaults depend on the machine; options override
// them.
#pragma once

#include <string>
#include <vector>

#include "bench/io/motion_choice.h"
#include "bench/measure/timing.h"
#include "bench/studies/study_sampling.h"
#include "common/backend/backend.h"

namespace spherepair {

enum class Level { quick, standard, full };

struct CheckSize {
  uint64_t n, steps;
  std::vector<uint> blocks;
};

struct Plan {
  Level level = Level::standard;
  bool hardware = false;  // a GPU is among the backends
  uint64_t seed = SceneOptions{}.seed;
  uint64_t every = 1;  // steps between two comparisons of the lockstep check
  std::vector<SceneOptions> scenes;
  std::vector<Method> methods;
  std::vector<uint> blocks;
  uint table_block = CollideOptions{}.block;  // group size of tables with one column per method
  std::vector<CheckSize> checks;
  ContactChoice contact;  // contacts of the checks
  std::vector<uint64_t> paper_sizes, count_sizes, method_sizes, exactness_sizes, scale_sizes, step_sizes, grid_sizes;
  uint64_t count_steps = 1000, count_steps_large = 100;  // large: 32,768 spheres
  uint64_t grazing_pairs = 10000;
  double row_seconds = 8;  // without a GPU, sizes of a table that would take longer are left out
  std::vector<std::string> tables;
  Sampling sampling = study_sampling();
};

// Overrides from the command line; empty: not given.
struct PlanOptions {
  bool quick = false, full = false;
  std::vector<std::string> scenes, methods, tables;
  std::vector<uint> blocks;
  std::vector<uint64_t> sizes;
  MotionChoice motion;
  int64_t steps = -1;
  uint64_t every = 1, seed = SceneOptions{}.seed;
  int rounds = 0;
  double min_seconds = 0;
};

// Throws std::invalid_argument naming the unknown value and the known ones.
Plan make_plan(const PlanOptions& options, bool hardware);

bool is_wanted(const Plan& plan, Method method);

}  // namespace spherepair
