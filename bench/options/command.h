// SPDX-License-Identifier: MIT
// What every subcommand is given, and what it returns.
#pragma once

#include "api/open.h"
#include "bench/measure/session.h"

namespace spherepair {

// Documented in --help: scripts rely on them.
enum ExitCode { kOk = 0, kDifference = 1, kUsage = 2, kDeviceFailure = 3 };

// How much a command prints: errors and warnings about the result, a summary, reasons and details as well.
enum class Verbosity { quiet, normal, verbose };

struct CommandLine {
  std::vector<std::string> words;  // argv, for the record
  OpenOptions open;
  Opener opener = open_backend;
  Clocks clocks = host_clocks();  // of StudyLoad
};

}  // namespace spherepair
