// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>

#include "bench/cli/commands.h"

namespace spherepair {

struct ViewOptions {
  std::string backend, method;  // at the start
  StartOptions start;
  uint width = 1280, height = 720;  // of the window, pixels
  std::optional<double> speed;      // see Viewer::Options; none: 1, or 0 with `frames`
  uint64_t frames = 0;              // the window closes after them; 0: never
  std::string screenshot_file;      // of the last frame
  std::string keys;                 // one key press per frame, as if by the user
};
int view_command(const CommandLine& line, const ViewOptions& options);

void add_view(CLI::App& app, CommandLine& line, std::function<int()>& action);

}  // namespace spherepair
