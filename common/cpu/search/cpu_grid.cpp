// SPDX-License-Identifier: MIT
#include "common/cpu/search/cpu_grid.h"

#include <omp.h>

#include <algorithm>
#include <atomic>

#include "common/backend/cpu_team.h"
#include "common/shared/exact.h"

namespace spherepair {
namespace {

constexpr uint64_t alone = 32768;  // up to this many spheres, a second thread does not pay

}  // namespace

// The pairs that one thread finds. Only this thread counts contacts within its chunk of places. Several threads may
// count contacts of other places, which therefore have counters of their own.
class CpuGrid::Finder final : public CandidateSink {
 public:
  Finder(CpuGrid& grid, const SearchInput& search, const Params& p, GrowingList<uint64_t>& list)
      : simd_(grid.simd_),
        order_(grid.cells_.order()),
        p_(p),
        near_counts_(grid.near_counts_.data()),
        far_counts_(grid.far_counts_.data()),
        list_(search.options.want_pairs ? &list : nullptr) {}

  void search(Chunk columns_per_group) {
    chunk_ = columns_per_group;
    std::fill(near_counts_ + columns_per_group.first, near_counts_ + columns_per_group.last, 0u);
    simd_.find_candidates(order_, p_, columns_per_group.first, columns_per_group.last, candidates_, *this);
    take(candidates_);
  }

  void take(Candidates& candidates) override {
    resolve_undecided(candidates);
    const Fingerprint sum = simd_.mix(candidates, order_.id, keys_);
    totals_.pairs += candidates.size;
    totals_.fingerprint.a += sum.a;
    totals_.fingerprint.b += sum.b;
    for (uint k = 0; k < candidates.size; ++k) {
      ++near_counts_[candidates.mine[k]];
      add_contact(candidates.other[k]);
    }
    if (list_) list_->append(keys_, candidates.size);
    candidates.size = 0;
  }

  void add_to(Collisions& totals) const {
    totals.pairs += totals_.pairs;
    totals.fingerprint.a += totals_.fingerprint.a;
    totals.fingerprint.b += totals_.fingerprint.b;
    totals.deferred += totals_.deferred;
    for (uint stage = 0; stage < STAGES; ++stage) totals.decided_by[stage] += totals_.decided_by[stage];
  }

 private:
  void add_contact(uint place) {
    if (place - chunk_.first < chunk_.last - chunk_.first) {
      ++near_counts_[place];
    } else {
      std::atomic_ref(far_counts_[place]).fetch_add(1, std::memory_order_relaxed);
    }
  }

  // Decides the undecided candidate pairs and drops those that do not collide.
  void resolve_undecided(Candidates& candidates) {
    uint flags = 0;
    for (uint k = 0; k < candidates.size; ++k) flags |= candidates.other[k];
    if (!(flags & UNDECIDED_BIT)) return;
    uint kept = 0;
    for (uint k = 0; k < candidates.size; ++k) {
      const uint mine = candidates.mine[k], other = candidates.other[k] & ~UNDECIDED_BIT;
      if (candidates.other[k] & UNDECIDED_BIT && !decide(mine, other)) continue;
      candidates.mine[kept] = mine;
      candidates.other[kept++] = other;
    }
    candidates.size = kept;
  }

  bool decide(uint mine, uint other) {
    if (!p_.search.defer_undecided) return false;
    const Verdict verdict = decide_exact(sphere(mine), sphere(other));
    ++totals_.deferred;
    ++totals_.decided_by[verdict.stage];
    return verdict.collide;
  }

  vec4 sphere(uint place) const {
    return {order_.x[place], order_.y[place], order_.z[place], order_.radius ? order_.radius[place] : p_.radius};
  }

  const GridSimd& simd_;
  const CellOrder order_;
  const Params& p_;
  uint *near_counts_, *far_counts_;
  GrowingList<uint64_t>* list_;
  Chunk chunk_{};
  Collisions totals_;
  Candidates candidates_;
  uint64_t keys_[candidates_at_once];
};

PairsFound CpuGrid::search(const SearchInput& search, const GridPlan& plan, bool keep_cells) {
  Params p = search.params;
  n_ = search.positions.size();
  p.n = uint(n_);
  p.grid = grid_params(plan);
  if (!keep_cells) cells_.sort(search.positions, p.grid, !search.equal_radii, search.threads);
  near_counts_.resize(n_);
  far_counts_.resize(n_);
  PairsFound found;
  found.totals = find(search, p);
  found.totals.colliding_spheres = join_counts(search.threads);
  if (!search.options.want_pairs) return found;
  join_lists<uint64_t>(lists_, found.totals.pairs, 2 * sizeof(Pair) * found.totals.pairs,
                       [&] { list_sort_.sort(lists_, n_, search.threads, found.list); });
  return found;
}

Collisions CpuGrid::find(const SearchInput& search, const Params& p) {
  Collisions totals;
  const std::vector<Chunk> chunks = cells_.chunks(search.threads);
  const int threads = team_of(chunks.size(), search.threads);
  lists_.resize(size_t(threads));
  for (GrowingList<uint64_t>& list : lists_) list.clear();
#pragma omp parallel num_threads(threads)
  {
#pragma omp for schedule(static)
    for (uint64_t k = 0; k < n_; ++k) far_counts_[k] = 0;
    Finder finder(*this, search, p, lists_[size_t(omp_get_thread_num())]);
#pragma omp for schedule(dynamic, 1)
    for (size_t s = 0; s < chunks.size(); ++s) finder.search(chunks[s]);
#pragma omp critical
    finder.add_to(totals);
  }
  return totals;
}

uint64_t CpuGrid::join_counts(int threads) {
  uint64_t with_contacts = 0;
#pragma omp parallel for num_threads(threads) schedule(static) reduction(+ : with_contacts) if (n_ > alone)
  for (uint64_t k = 0; k < n_; ++k) {
    near_counts_[k] += far_counts_[k];
    with_contacts += colliding(near_counts_[k]);
  }
  return with_contacts;
}

std::vector<uint> CpuGrid::counts(int threads) const {
  std::vector<uint> counts(n_);
  const uint* id = cells_.order().id;
#pragma omp parallel for num_threads(threads) schedule(static) if (n_ > alone)
  for (uint64_t k = 0; k < n_; ++k) counts[id[k]] = near_counts_[k];
  return counts;
}

}  // namespace spherepair
