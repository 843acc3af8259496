// SPDX-License-Identifier: MIT
#include "common/lists/pair_rows.h"

#include <numeric>
#include <span>

namespace spherepair {

// Sums up each share of the rows, then adds what is before it.
void PairRows::make_room(bool with_shifts) {
  constexpr int64_t share = 1 << 14;
  const int64_t shares = (rows() + share - 1) / share;
  const auto sums_of = [&](int64_t k) {
    return std::span(offsets).subspan(size_t(k * share) + 1, size_t(std::min(share, rows() - k * share)));
  };
#pragma omp parallel for schedule(static) if (shares > 1)
  for (int64_t k = 0; k < shares; ++k) std::partial_sum(sums_of(k).begin(), sums_of(k).end(), sums_of(k).begin());
  std::vector<int64_t> before = {0};
  for (int64_t k = 0; k < shares; ++k) before.push_back(before.back() + sums_of(k).back());
#pragma omp parallel for schedule(static) if (shares > 1)
  for (int64_t k = 1; k < shares; ++k)
    for (int64_t& sum : sums_of(k)) sum += before[size_t(k)];
  second.resize(size_t(count()));
  if ((shifted = with_shifts)) shifts.resize(size_t(count()));
}

std::vector<ListedPair> PairRows::pairs() const {
  std::vector<ListedPair> list(static_cast<size_t>(count()));
  for_pairs([&](int64_t row, int64_t k) { list[size_t(k)] = {uint32_t(row), second[size_t(k)], shift(k)}; });
  return list;
}

PairRows rows_of(const std::vector<ListedPair>& list, uint64_t firsts) {
  PairRows rows;
  rows.offsets.assign(firsts + 1, 0);
  for (const ListedPair& pair : list) ++rows.offsets[pair.first + 1];
  rows.make_room(true);
  in_shares(0, rows.count(), [&](int64_t begin, int64_t end) {
    for (int64_t k = begin; k < end; ++k)
      rows.second[size_t(k)] = list[size_t(k)].second, rows.shifts[size_t(k)] = list[size_t(k)].shift;
  });
  return rows;
}

}  // namespace spherepair
