// SPDX-License-Identifier: MIT
// spherepair skips: what is saved by leaving out what a scene does not need, and by what one API alone offers. Each is
// timed on and off, in turns, after both have given the same set.
#pragma once

#include <CLI/App.hpp>
#include <memory>

#include "bench/cli/commands.h"
#include "bench/studies/ablation_study.h"

namespace spherepair {

std::shared_ptr<AblateOptions> add_ablate_options(CLI::App& command);
int ablate_command(const CommandLine& line, const AblateOptions& options);

}  // namespace spherepair
