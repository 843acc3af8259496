// SPDX-License-Identifier: MIT
// The subcommands and their options. Each returns the exit code.
#pragma once

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
  std::string input_file;  // spheres from a file, in place of a scene
  uint block = CollideOptions{}.block;
  uint64_t steps = 0;
  bool per_step = false, naive = false;
  std::string pairs_file, json_file;
};
int run_command(const CommandLine& line, const RunOptions& options);

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
