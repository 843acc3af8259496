// SPDX-License-Identifier: MIT
// How much a command prints.
#pragma once

namespace CLI {
class App;
}

namespace spherepair {

enum class Verbosity {
  quiet,   // errors, and warnings about the result
  normal,  // a short summary
  verbose  // reasons and details as well
};

// --quiet and --verbose, which exclude each other.
void add_verbosity_options(CLI::App& command, Verbosity& verbosity);

}  // namespace spherepair
