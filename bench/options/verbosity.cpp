// SPDX-License-Identifier: MIT
#include "bench/options/verbosity.h"

#include <CLI/CLI.hpp>

namespace spherepair {

void add_verbosity_options(CLI::App& command, Verbosity& verbosity) {
  auto* quiet = command.add_flag_callback(
      "--quiet", [&verbosity] { verbosity = Verbosity::quiet; }, "Print errors and warnings about the result alone");
  command
      .add_flag_callback(
          "--verbose", [&verbosity] { verbosity = Verbosity::verbose; },
          "Print reasons and details too: why a backend and method were taken, times, numbers of contacts")
      ->excludes(quiet);
}

}  // namespace spherepair
