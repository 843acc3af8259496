// SPDX-License-Identifier: MIT
// The input and the exit code of every subcommand.
#pragma once

#include <functional>

#include "api/open.h"
#include "bench/measure/session.h"

namespace spherepair {

// Documented in --help: scripts rely on them.
enum ExitCode { kOk = 0, kDifference = 1, kUsage = 2, kDeviceFailure = 3 };

// How much a command prints. quiet: errors, and warnings about the result. normal: also a summary. verbose: also
// reasons and details.
enum class Verbosity { quiet, normal, verbose };

using Action = std::function<int()>;  // what a subcommand does once its options are parsed

struct CommandLine {
  std::vector<std::string> words;  // argv, for the record
  OpenOptions open;
  Opener opener = open_backend;
  Clocks clocks = host_clocks();  // for StudyLoad
};

}  // namespace spherepair
