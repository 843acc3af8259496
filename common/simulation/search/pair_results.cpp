// SPDX-License-Identifier: MIT
// Completes a search and reads its totals, counts and pairs.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "common/simulation/search/pair_search.h"
#include "common/simulation/search/search_summary.h"

namespace spherepair {
namespace {

constexpr uint tally_groups = 1024;
constexpr uint64_t most_near = uint64_t(1) << 31;  // kernels over near pairs count in 32 bits
constexpr uint64_t most_listed = std::numeric_limits<uint>::max();

}  // namespace

std::vector<uint> PairSearch::read_summary() {
  return context_.buffers.read<uint>(SLOT_SUMMARY, SUMMARY_SLOTS * SUMMARY_WORDS);
}

bool PairSearch::grow_lists(const std::vector<uint>& summary) {
  const uint64_t deferred = summary[SUM_DEFERRED], listed = summary[SUM_LISTED];
  const bool short_deferred = deferred > context_.params.search.deferred_capacity;
  const bool short_pairs = options_.want_pairs && listed > context_.params.search.pair_capacity;
  if (short_deferred) context_.buffers.resize(SLOT_DEFERRED, (deferred + deferred / 8) * sizeof(uvec2));
  if (short_pairs) context_.buffers.resize(SLOT_PAIR, std::min(listed + listed / 8, most_listed) * sizeof(uvec2));
  return short_deferred || short_pairs;
}

std::vector<uint> PairSearch::complete_lists() {
  std::vector<uint> summary = read_summary();
  const bool left = summary[SUM_DEFERRED] != 0;
  if (options_.exact && !left) resolved_in_step_.erase(kind());
  if (options_.exact && left) resolved_in_step_.insert(kind());
  if (left && !resolved_) {
    resolve_undecided();
    summary = read_summary();
  }
  while (grow_lists(summary)) {
    launch();
    summary = read_summary();
  }
  resolved_ = true;
  return summary;
}

uint64_t PairSearch::list_pairs(CollideOptions options) {
  options.want_pairs = true;
  enqueue(options);
  const uint64_t pairs = sum_of(complete_lists(), SUM_DEFERRED).pairs;
  if (pairs > most_near)
    throw BackendError(
        fmt::format("{}: {} pairs are near each other, but a list holds 2^31 at most", context_.name(), pairs));
  return pairs;
}

void PairSearch::complete() {
  complete_lists();
  context_.launch({Kernel::tally, SERVICE_BLOCK, {}, {tally_groups, 1, 1}, order_});
  totals_ = sum_of(read_summary(), search_decides_ ? SUM_UNDECIDED : SUM_DEFERRED);
  if (options_.want_pairs && context_.device.library())
    context_.device.library()->sort_pairs(context_.buffers.memory(SLOT_PAIR), std::min(totals_.pairs, most_listed));
  results_ = Results::complete;
}

void PairSearch::require_complete() const {
  if (results() == Results::none)
    throw BackendError(
        fmt::format("{}: no collision step to report since the last move; call collide first", context_.name()));
  if (results() != Results::complete)
    throw BackendError(
        fmt::format("{}: the last collision step was only enqueued; call collide for its results", context_.name()));
}

const Collisions& PairSearch::totals() const {
  require_complete();
  return totals_;
}

std::vector<uint> PairSearch::counts() {
  require_complete();
  const std::vector<uint> counts = context_.buffers.read<uint>(count_slot(order_), context_.n);
  if (order_ != Order::cells) return counts;
  const std::vector<uint> indices = sorter_.sphere_indices();
  std::vector<uint> by_index(context_.n);
  for (uint64_t k = 0; k < context_.n; ++k) by_index[indices[k]] = counts[k];
  return by_index;
}

std::vector<Pair> PairSearch::pairs() {
  const uint64_t count = totals().pairs;
  if (!options_.want_pairs)
    throw BackendError(fmt::format("{}: no pair list was requested; set want_pairs", context_.name()));
  if (count > most_listed)
    throw BackendError(
        fmt::format("{}: {} pairs collide, but a list holds 2^32 - 1 at most; ask for the numbers without the list",
                    context_.name(), count));
  std::vector<Pair> pairs = context_.buffers.read<Pair>(SLOT_PAIR, count);
  if (!context_.device.library()) std::ranges::sort(pairs);
  return pairs;
}

}  // namespace spherepair
