// SPDX-License-Identifier: MIT
#include "tests/fuzz/fuzz.h"

#include <cstdio>
#include <cstdlib>

#include "api/open.h"
#include "bench/check/step_result.h"
#include "tests/support/sphere_files.h"

namespace spherepair {

std::string input_file(const std::string& name, std::string_view bytes) {
  static const ScratchFolder folder;
  return folder.write(name, std::string(bytes));
}

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

Backend& fuzzed_backend() {
  static const std::unique_ptr<Backend> backend = open_backend("cpu", {.threads = 1});
  return *backend;
}

void require_one_set() {
  Backend& backend = fuzzed_backend();
  const auto ask_for = [&](Method method, Cells cells = Cells::automatic) {
    backend.collide({.method = method, .want_pairs = true, .grid = {.cells = cells}});
    return result_of(backend, true);
  };
  const StepResult expected = ask_for(Method::sequential);
  require(same_result(expected, ask_for(Method::parallel)), "parallel finds what sequential does");
  for (const Cells cells : {Cells::automatic, Cells::dense, Cells::hashed})
    require(same_result(expected, ask_for(Method::collide_grid, cells)), "the grid finds what all pairs do");
}

}  // namespace spherepair
