// SPDX-License-Identifier: MIT
// results.json: what is read as a record of a comparison equals itself.
#include "bench/check/equality.h"
#include "tests/fuzz/fuzz.h"

using namespace spherepair;

FUZZ(results) {
  const std::string file = input_file("results.json", text_of(data, size));
  const auto results = unless_refused([&] { return read_results(file); });
  if (!results) return;
  const auto same = unless_refused([&] { return compare_records(*results, *results); });
  require(!same || (same->differences.empty() && same->only_left.empty() && same->only_right.empty()),
          "a record equals itself");
}
