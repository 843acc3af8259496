// SPDX-License-Identifier: MIT
// spherepair ablate: what each optimisation and each API feature saves. Each is timed on and off, in interleaved
// rounds, after a check that both give the same results.
#pragma once

#include <CLI/App.hpp>
#include <memory>

#include "bench/cli/commands.h"
#include "bench/studies/ablation_study.h"

namespace spherepair {

std::shared_ptr<AblateOptions> add_ablate_options(CLI::App& command);
int ablate_command(const CommandLine& line, const AblateOptions& options);

}  // namespace spherepair
