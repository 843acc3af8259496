// SPDX-License-Identifier: MIT
#include "common/cpu/search/cpu_pairs.h"

#include <omp.h>

#include <algorithm>
#include <bit>
#include <optional>
#include <stdexcept>

#include "common/backend/cpu_team.h"
#include "common/backend/growing_list.h"
#include "common/cpu/search/cpu_simd.h"
#include "common/shared/hash.h"

namespace spherepair {
namespace {

constexpr uint64_t pairs_per_thread = 1u << 16;  // number of pairs that is worth another thread

// The pairs that one thread finds. Sums do not depend on the order, so results do not depend on the number of threads.
class Finder {
 public:
  Finder(const SearchInput& search, GrowingList<Pair>& list)
      : search_(search), counts_(search.positions.size()), list_(list) {}

  template <bool equal_radii>
  void test_pair(vec4 a, vec4 b, uint i, uint j) {
    const Params& p = search_.params;
    const uint verdict = equal_radii
                             ? filter_equal(squared_distance(a, b), p.search.apart_above, p.search.collide_below)
                             : filter_pair(a, b, p.search.filter_scale, p.search.filter_offset);
    if (verdict != APART) [[unlikely]]
      close(a, b, i, j, verdict);
  }

  void test_pair(uint i, uint j) {
    const vec4 a = search_.positions[i], b = search_.positions[j];
    search_.equal_radii ? test_pair<true>(a, b, i, j) : test_pair<false>(a, b, i, j);
  }

  void add_to(PairsFound& found) const {
    found.totals.pairs += totals_.pairs;
    found.totals.fingerprint.a += totals_.fingerprint.a;
    found.totals.fingerprint.b += totals_.fingerprint.b;
    found.totals.deferred += totals_.deferred;
    for (uint stage = 0; stage < STAGES; ++stage) found.totals.decided_by[stage] += totals_.decided_by[stage];
    for (size_t i = 0; i < counts_.size(); ++i) found.counts[i] += counts_[i];
  }

 private:
  // Decides a pair that is not apart. It is not inlined, as it would take registers from the loops over all pairs.
  [[gnu::noinline]] void close(vec4 a, vec4 b, uint i, uint j, uint verdict) {
    if (verdict == UNDECIDED && !(search_.params.search.defer_undecided && resolve_undecided(a, b))) return;
    ++totals_.pairs;
    totals_.fingerprint.a += pair_mix_a(i, j);
    totals_.fingerprint.b += pair_mix_b(i, j);
    ++counts_[i];
    ++counts_[j];
    const Pair pair{i, j};
    if (search_.options.want_pairs) list_.append(&pair, 1);
  }

  bool resolve_undecided(vec4 a, vec4 b) {
    const Verdict verdict = decide_exact(a, b);
    ++totals_.deferred;
    ++totals_.decided_by[verdict.stage];
    return verdict.collide;
  }

  const SearchInput& search_;
  std::vector<uint> counts_;
  Collisions totals_;
  GrowingList<Pair>& list_;
};

// Runs the paper's code 2 on the spheres from `first` to before `last`.
template <bool equal_radii>
void double_loop(std::span<const vec4> spheres, uint first, uint last, Finder& finder) {
  for (uint i = first; i < last; ++i) {
    const vec4 a = spheres[i];
    for (uint j = i + 1; j < last; ++j) finder.test_pair<equal_radii>(a, spheres[j], i, j);
  }
}
void double_loop(const SearchInput& search, uint first, uint last, Finder& finder) {
  search.equal_radii ? double_loop<true>(search.positions, first, last, finder)
                     : double_loop<false>(search.positions, first, last, finder);
}

struct Tiles {
  ColumnTile columns;
  RowTile rows;
  NearList near;
};

void load_rows(const SearchInput& search, uint first, float share, RowTile& rows) {
  rows.count = std::min<uint>(tile_rows, uint(search.positions.size()) - first);
  for (uint r = 0; r < rows.count; ++r) {
    const vec4 sphere = search.positions[first + r];
    rows.form[r] = gram_form(sphere, search.positions[first], share);
    rows.radius[r] = sphere.w;
  }
}

// Loads a tile and returns its number of columns. The last sphere repeats to the end of the tile.
uint load_columns(const SearchInput& search, uint start, ColumnTile& tile) {
  const uint columns = std::min<uint>(tile_columns, uint(search.positions.size()) - start);
  for (uint c = 0; c < tile_columns; ++c) {
    const vec4 sphere = search.positions[start + std::min(c, columns - 1)];
    tile.x[c] = sphere.x;
    tile.y[c] = sphere.y;
    tile.z[c] = sphere.z;
    tile.radius[c] = sphere.w;
  }
  return columns;
}

void test_near(const NearList& near, uint first_row, uint start, uint end, Finder& finder) {
  for (uint k = 0; k < near.size; ++k) {
    const NearColumns& entry = near.entry[k];
    const uint row = first_row + entry.row;
    for (uint64_t bits = entry.bits; bits; bits &= bits - 1) {
      const uint column = start + entry.first_column + uint(std::countr_zero(bits));
      if (row < column && column < end) finder.test_pair(row, column);
    }
  }
}

void test_row_block(const SearchInput& search, uint first, Tiles& tiles, Finder& finder) {
  const Simd& simd = best_simd();
  const float share = search.equal_radii ? 1.0f : 0.5f;
  load_rows(search, first, share, tiles.rows);
  for (uint64_t start = first; start < search.positions.size(); start += tile_columns) {
    const uint columns = load_columns(search, uint(start), tiles.columns);
    simd.form_columns(tiles.columns, search.positions[first], share);
    simd.find_near(tiles.columns, columns, tiles.rows, search.equal_radii, tiles.near);
    test_near(tiles.near, first, uint(start), uint(start) + columns, finder);
  }
}

// Runs test_block(block, tiles, finder) for every block on `threads` threads.
template <typename TestBlock>
PairsFound search_blocks(const SearchInput& search, int threads, uint64_t blocks, TestBlock test_block) {
  PairsFound found;
  found.counts.resize(search.positions.size());
  std::vector<GrowingList<Pair>> lists(static_cast<size_t>(threads));
  TeamErrors errors;
#pragma omp parallel num_threads(threads)
  {
    const size_t own = size_t(omp_get_thread_num());
    std::optional<Finder> finder;  // none if memory runs out
    errors.run(own, [&] { finder.emplace(search, lists[own]); });
    Tiles tiles;
#pragma omp for schedule(dynamic, 1)
    for (uint64_t block = 0; block < blocks; ++block)
      if (finder) test_block(uint(block), tiles, *finder);
#pragma omp critical
    if (finder) finder->add_to(found);
  }
  errors.rethrow();
  found.list = joined<Pair>(lists, found.totals.pairs);
  found.totals.colliding_spheres = uint64_t(std::ranges::count_if(found.counts, colliding));
  return found;
}

}  // namespace

PairsFound search_sequential(const SearchInput& search) {
  return search_blocks(search, 1, 1, [&](uint, Tiles&, Finder& finder) {
    double_loop(search, 0, uint(search.positions.size()), finder);
  });
}

// Tests all pairs. Few spheres are left to one thread: waking the others costs as much as some 10^5 pairs.
PairsFound search_parallel(const SearchInput& search) {
  const uint64_t n = search.positions.size();
  const int threads = team_of(n * n / 2 / pairs_per_thread, search.threads);
  return search_blocks(search, threads, (n + tile_rows - 1) / tile_rows, [&](uint block, Tiles& tiles, Finder& finder) {
    test_row_block(search, block * tile_rows, tiles, finder);
  });
}

PairsFound search_groups(const SearchInput& search) {
  const uint64_t n = search.positions.size(), size = search.options.block;
  if (size == 0) throw std::invalid_argument("the group size is 0, but must be at least 1");
  return search_blocks(search, search.threads, (n + size - 1) / size, [&](uint group, Tiles&, Finder& finder) {
    double_loop(search, uint(group * size), uint(std::min((group + 1) * size, n)), finder);
  });
}

}  // namespace spherepair
