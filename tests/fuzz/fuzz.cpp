// SPDX-License-Identifier: MIT
#include "tests/fuzz/fuzz.h"

#include <cstdio>
#include <cstdlib>
#include <map>

#include "api/open.h"
#include "bench/check/step_result.h"
#include "tests/support/sphere_files.h"

namespace spherepair {
namespace {

using Fuzzed = void (*)(const uint8_t* data, size_t size);

std::map<std::string, Fuzzed>& targets() {
  static std::map<std::string, Fuzzed> all;
  return all;
}

Fuzzed chosen_target() {
  const char* const name = std::getenv("FUZZ_TARGET");
  const auto found = targets().find(name ? name : "");
  if (found != targets().end()) return found->second;
  std::fputs("FUZZ_TARGET must be one of:", stderr);
  for (const auto& [target, fuzzed] : targets()) std::fprintf(stderr, " %s", target.c_str());
  std::fputs("\n", stderr);
  std::exit(2);
}

}  // namespace

FuzzTarget::FuzzTarget(const char* name, Fuzzed fuzzed) { targets().emplace(name, fuzzed); }

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

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  static const auto fuzzed = spherepair::chosen_target();
  fuzzed(data, size);
  return 0;
}
