// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "bench/cli/commands.h"

namespace spherepair {

struct ViewOptions {
  std::string backend, method;  // at first
  StartOptions start;
  uint width = 1280, height = 720;  // of the window, pixels
  uint64_t frames = 0;              // then it closes by itself; 0: never
  std::string screenshot_file;      // of the last frame
  std::string keys;                 // pressed one a frame, as if the user had
};
int view_command(const CommandLine& line, const ViewOptions& options);

void add_view(CLI::App& app, CommandLine& line, std::function<int()>& action);

}  // namespace spherepair
