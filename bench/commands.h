// SPDX-License-Identifier: MIT
// The subcommands and their options. Each returns the exit code.
#pragma once

#include <optional>

#include "plan.h"

namespace spherepair {

// Documented in --help; scripts rely on them.
enum ExitCode { kOk = 0, kDifference = 1, kUsage = 2, kDeviceTrouble = 3 };

struct CommandLine {
  std::vector<std::string> words;  // for the record
  OpenOptions open;
};

struct DevicesOptions {
  std::vector<std::string> backends;
  std::string json_file;
};
int devices_command(const CommandLine& line, const DevicesOptions& options);

struct RunOptions {
  std::string backend = "cpu", method;  // no method: the backend's fast one
  SceneOptions scene;
  std::string input_file;         // spheres from a file, in place of a scene
  std::optional<float> radius;    // of the spheres of that file
  std::optional<uint64_t> frame;  // of that file
  uint block = CollideOptions{}.block;
  MotionChoice motion = {.method = motion_name(MotionMethod::anchored)};  // what the measurements favour
  uint64_t steps = 0;
  bool per_step = false, naive = false, swept = false;
  std::string pairs_file, json_file;
  std::string save_file, resume_file;  // checkpoints
  uint64_t save_every = 0;             // steps; 0: only at the end
};
int run_command(const CommandLine& line, const RunOptions& options);

struct PairsOptions {
  std::string backend, method;  // no backend: the fastest that opens; no method: the backend's fast one
  std::string input_file, output_file, json_file;
  std::optional<float> radius;
  std::optional<uint64_t> frame;
  uint block = CollideOptions{}.block;
};
int pairs_command(const CommandLine& line, const PairsOptions& options);

struct CompareOptions {
  std::vector<std::string> backends;
  PlanOptions plan;
  std::string results;  // empty: default_results()
};
int compare_command(const CommandLine& line, const CompareOptions& options);

struct EqualOptions {
  std::string left, right;
};
int equal_command(const EqualOptions& options);

}  // namespace spherepair
