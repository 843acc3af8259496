// SPDX-License-Identifier: MIT
// spherepair skips: what is saved by leaving out what a scene does not need, and by what one API alone offers. Each is
// timed on and off, in turns, after both have given the same set.
#pragma once

#include <CLI/App.hpp>
#include <memory>

#include "bench/cli/commands.h"
#include "bench/studies/skip_study.h"

namespace spherepair {

std::shared_ptr<SkipsOptions> add_skips_options(CLI::App& command);
int skips_command(const CommandLine& line, const SkipsOptions& options);

}  // namespace spherepair
