// SPDX-License-Identifier: MIT
#include "common/simulation/search/search_summary.h"

namespace spherepair {
namespace {

uint64_t join(const uint* words) { return uint64_t(words[1]) << 32 | words[0]; }

}  // namespace

Collisions sum_of(const std::vector<uint>& summary, uint deferred_word) {
  Collisions total;
  for (uint row = 0; row < SUMMARY_SLOTS; ++row) {
    const uint* words = &summary[row * SUMMARY_WORDS];
    total.pairs += join(words + SUM_PAIRS);
    total.fingerprint.a += join(words + SUM_MIX_A);
    total.fingerprint.b += join(words + SUM_MIX_B);
    total.colliding_spheres += join(words + SUM_COLLIDING);
    for (uint stage = 0; stage < STAGES; ++stage) total.decided_by[stage] += words[SUM_STAGE + stage];
    total.deferred += words[deferred_word];
  }
  return total;
}

}  // namespace spherepair
