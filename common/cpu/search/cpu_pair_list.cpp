// SPDX-License-Identifier: MIT
#include "common/cpu/search/cpu_pair_list.h"

#include <omp.h>

#include <algorithm>
#include <bit>
#include <utility>

#include "common/backend/cpu_team.h"

namespace spherepair {
namespace {

constexpr uint64_t pairs_per_bucket = 4096, most_pair_buckets = 4096;
constexpr uint64_t piece = 1 << 17;  // pairs that one thread splits at a time
constexpr uint64_t sparse = 8;       // from so many spheres a pair on, sorting by comparison is faster
constexpr ptrdiff_t short_run = 24;

Pair pair_of(uint64_t key) { return {uint(key >> 32), uint(key)}; }

void sort_run(Pair* begin, Pair* end) {
  const auto less = [](const Pair& a, const Pair& b) { return a.second < b.second; };
  if (end - begin > short_run) return std::sort(begin, end, less);
  for (Pair* at = begin; at < end; ++at) {
    const Pair pair = *at;
    Pair* to = at;
    for (; to > begin && pair.second < to[-1].second; --to) *to = to[-1];
    *to = pair;
  }
}

// Sorts the keys whose first spheres begin at `first`, at most as many as `places` has entries.
void sort_bucket(std::span<uint64_t> keys, uint64_t first, std::span<uint> places, Pair* sorted) {
  if (keys.size() * sparse < places.size()) {
    std::ranges::sort(keys);
    std::ranges::transform(keys, sorted, pair_of);
    return;
  }
  std::ranges::fill(places, 0u);
  for (uint64_t key : keys) ++places[(key >> 32) - first];
  uint place = 0;
  for (uint& entry : places) place += std::exchange(entry, place);
  for (uint64_t key : keys) sorted[places[(key >> 32) - first]++] = pair_of(key);
  uint begin = 0;
  for (uint end : places) {
    if (end - begin > 1) sort_run(sorted + begin, sorted + end);
    begin = end;
  }
}

}  // namespace

void PairSort::sort(std::span<const GrowingList<uint64_t>> lists, uint64_t n, int threads, std::vector<Pair>& sorted) {
  pieces_.clear();
  uint64_t pairs = 0;
  for (const GrowingList<uint64_t>& found : lists) {
    std::span<const uint64_t> list = found.values();
    pairs += list.size();
    for (; list.size() > piece; list = list.subspan(piece)) pieces_.push_back(list.first(piece));
    pieces_.push_back(list);
  }
  sorted.resize(pairs);
  if (pairs == 0) return;
  threads = team_of(pairs / pairs_per_bucket, threads);
  const uint64_t wanted = std::clamp<uint64_t>(std::max(pairs, n / sparse) / pairs_per_bucket, 1, most_pair_buckets);
  shift_ = uint(std::bit_width((n - 1) / wanted));
  split_.resize(pairs);
  const size_t buckets = ((n - 1) >> shift_) + 1;
  split(buckets, threads);
  const size_t firsts = size_t(1) << shift_;
  std::vector<uint> places(size_t(threads) * firsts);
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
  for (size_t b = 0; b < buckets; ++b)
    sort_bucket({split_.data() + begin_[b], begin_[b + 1] - begin_[b]}, uint64_t(b) << shift_,
                {places.data() + size_t(omp_get_thread_num()) * firsts, firsts}, sorted.data() + begin_[b]);
}

// Splits the keys into buckets of consecutive first spheres.
void PairSort::split(size_t buckets, int threads) {
  cursor_.assign(pieces_.size() * buckets, 0);
  begin_.assign(buckets + 1, 0);
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
  for (size_t k = 0; k < pieces_.size(); ++k)
    for (uint64_t key : pieces_[k]) ++cursor_[k * buckets + (key >> 32 >> shift_)];
  uint64_t place = 0;
  for (size_t b = 0; b < buckets; ++b) {
    for (size_t k = 0; k < pieces_.size(); ++k) place += std::exchange(cursor_[k * buckets + b], place);
    begin_[b + 1] = place;
  }
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
  for (size_t k = 0; k < pieces_.size(); ++k)
    for (uint64_t key : pieces_[k]) split_[cursor_[k * buckets + (key >> 32 >> shift_)]++] = key;
}

}  // namespace spherepair
