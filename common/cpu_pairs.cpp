// SPDX-License-Identifier: MIT
#include "cpu_pairs.h"

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <bit>

#include "cpu_simd.h"
#include "hash.h"

namespace spherepair {
namespace {

constexpr uint row_block = 256;

// What one thread has found. Sums do not depend on the order, so neither do the results on the number of threads.
class Finder {
 public:
  Finder(const PairSearch& search, std::span<uint> counts) : search_(search), counts_(counts) {}

  void meet(uint i, uint j) {
    const vec4 a = search_.positions[i], b = search_.positions[j];
    const Params& p = search_.params;
    const uint verdict = search_.equal_radii ? filter_equal(squared_distance(a, b), p.apart_above, p.collide_below)
                                             : filter_pair(a, b, p.filter_scale, p.filter_offset);
    if (verdict == COLLIDE || (verdict == UNDECIDED && p.defer_undecided && settle(a, b))) record(i, j);
  }

  void add_to(PairsFound& found) const {
    found.totals.pairs += totals_.pairs;
    found.totals.fingerprint.a += totals_.fingerprint.a;
    found.totals.fingerprint.b += totals_.fingerprint.b;
    found.totals.deferred += totals_.deferred;
    for (uint stage = 0; stage < STAGES; ++stage) found.totals.decided_by[stage] += totals_.decided_by[stage];
    found.list.insert(found.list.end(), list_.begin(), list_.end());
  }

 private:
  bool settle(vec4 a, vec4 b) {
    const Verdict verdict = decide_exact(a, b);
    ++totals_.deferred;
    ++totals_.decided_by[verdict.stage];
    return verdict.collide;
  }

  void record(uint i, uint j) {
    ++totals_.pairs;
    totals_.fingerprint.a += pair_mix_a(i, j);
    totals_.fingerprint.b += pair_mix_b(i, j);
    std::atomic_ref(counts_[i]).fetch_add(1, std::memory_order_relaxed);
    std::atomic_ref(counts_[j]).fetch_add(1, std::memory_order_relaxed);
    if (search_.options.want_pairs) list_.push_back({i, j});
  }

  const PairSearch& search_;
  std::span<uint> counts_;
  Collisions totals_;
  std::vector<Pair> list_;
};

void load_tile(const PairSearch& search, vec4 origin, uint start, ColumnTile& tile) {
  const float share = search.equal_radii ? 1.0f : 0.5f;
  const uint columns = std::min<uint>(tile_columns, uint(search.positions.size()) - start);
  for (uint c = 0; c < columns; ++c) {
    const vec4 sphere = search.positions[start + c];
    const vec4 form = gram_form(sphere, origin, share);
    tile.x[c] = form.x;
    tile.y[c] = form.y;
    tile.z[c] = form.z;
    tile.minus_w[c] = -form.w;
    tile.radius[c] = sphere.w;
  }
  for (uint c = columns; c < tile_columns; ++c) {
    tile.x[c] = tile.y[c] = tile.z[c] = tile.radius[c] = 0;
    tile.minus_w[c] = bits_float(0xFF800000u);  // never near
  }
}

void meet_near(const NearColumns& near, uint row, uint rows, uint start, Finder& finder) {
  for (uint chunk = 0; chunk < chunks; ++chunk) {
    if (!near.near[chunk]) continue;
    for (uint r = 0; r < rows; ++r) {
      for (uint v = 0; v < vectors; ++v) {
        for (uint bits = near.columns[chunk][r][v]; bits; bits &= bits - 1) {
          const uint column = start + chunk * chunk_columns + v * lanes + uint(std::countr_zero(bits));
          if (row + r < column) finder.meet(row + r, column);
        }
      }
    }
  }
}

void meet_row_block(const PairSearch& search, uint first, Finder& finder) {
  const uint n = uint(search.positions.size()), last = std::min(first + row_block, n);
  const float share = search.equal_radii ? 1.0f : 0.5f;
  const vec4 origin = search.positions[first];
  ColumnTile tile;
  NearColumns near;
  for (uint start = first; start < n; start += tile_columns) {
    load_tile(search, origin, start, tile);
    for (uint row = first; row < last; row += rows_at_once) {
      const uint rows = std::min(rows_at_once, last - row);
      vec4 forms[rows_at_once];
      float radii[rows_at_once];
      for (uint r = 0; r < rows_at_once; ++r) {
        const vec4 sphere = search.positions[row + std::min(r, rows - 1)];
        forms[r] = gram_form(sphere, origin, share);
        radii[r] = sphere.w;
      }
      meet_tile(tile, forms, radii, search.equal_radii, near);
      meet_near(near, row, rows, start, finder);
    }
  }
}

// Runs meet_block(block, finder) for every block, by as many threads as asked for.
template <typename MeetBlock>
PairsFound search_blocks(const PairSearch& search, int threads, uint64_t blocks, MeetBlock meet_block) {
  PairsFound found;
  found.counts.resize(search.positions.size());
#pragma omp parallel num_threads(threads)
  {
    Finder finder(search, found.counts);
#pragma omp for schedule(dynamic, 1)
    for (uint64_t block = 0; block < blocks; ++block) meet_block(uint(block), finder);
#pragma omp critical
    finder.add_to(found);
  }
  std::ranges::sort(found.list);
  found.totals.colliding_spheres = uint64_t(std::ranges::count_if(found.counts, colliding));
  return found;
}

}  // namespace

PairsFound search_sequential(const PairSearch& search) {
  const uint n = uint(search.positions.size());
  return search_blocks(search, 1, 1, [&](uint, Finder& finder) {
    for (uint i = 0; i < n; ++i) {
      for (uint j = i + 1; j < n; ++j) finder.meet(i, j);
    }
  });
}

PairsFound search_parallel(const PairSearch& search) {
  return search_blocks(search, search.threads, (search.positions.size() + row_block - 1) / row_block,
                       [&](uint block, Finder& finder) { meet_row_block(search, block * row_block, finder); });
}

PairsFound search_groups(const PairSearch& search) {
  const uint n = uint(search.positions.size()), size = search.options.block;
  return search_blocks(search, search.threads, (n + size - 1) / size, [&](uint group, Finder& finder) {
    const uint end = std::min((group + 1) * size, n);
    for (uint i = group * size; i < end; ++i) {
      for (uint j = i + 1; j < end; ++j) finder.meet(i, j);
    }
  });
}

}  // namespace spherepair
