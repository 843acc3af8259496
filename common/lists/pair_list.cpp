// SPDX-License-Identifier: MIT
#include "common/lists/pair_list.h"

#include <algorithm>
#include <numeric>

#include "common/backend/cpu_team.h"
#include "common/lists/device_lists.h"
#include "common/lists/host_lists.h"
#include "common/lists/list_spheres.h"

namespace spherepair {
namespace {

std::vector<Pair> colliding_pairs(Search& search, std::vector<vec4> spheres, const CollideOptions& options) {
  if (spheres.size() < 2) return {};
  Scene scene{.name = "list"};
  scene.velocities.resize(spheres.size(), vec4{0, 0, 0, 0});
  scene.equal_radii = std::ranges::all_of(spheres, [&](const vec4& sphere) { return sphere.w == spheres[0].w; });
  scene.positions = std::move(spheres);
  search.upload(scene);
  search.collide(options);
  return search.pairs();
}

class Lister {
 public:
  Lister(const ListProblem& problem, const ListPlan& plan)
      : problem_(problem), plan_(plan), looking_(problem.firsts().size()), excluded_(problem) {}

  void add_points_themselves(std::vector<ListedPair>& list) const {
    for (uint32_t i = 0; i < problem_.set.size(); ++i)
      if (const ListedPair self{i, i, {}}; accepts(self, plan_.systems()[i])) list.push_back(self);
  }

  // What `add` reads of the pair's second sphere.
  void prefetch(const Pair& pair) const {
    if (pair.second >= looking_) return __builtin_prefetch(&plan_.images()[pair.second - looking_]);
    if (problem_.asks) return;
    __builtin_prefetch(&problem_.set.points[pair.second]);
    plan_.prefetch_cell(pair.second);
  }

  // Appends the listed pairs of two colliding spheres: 0, 1 or 2.
  void add(const Pair& pair, std::vector<ListedPair>& list) const {
    if (pair.first >= looking_) return;  // two images
    const uint32_t system = plan_.systems()[pair.first];
    if (pair.second < looking_) {
      if (problem_.asks || plan_.systems()[pair.second] != system) return;
      const ListedPair both{pair.first, pair.second, plan_.shift_of(pair.first, pair.second, {})};
      if (!accepts(both, system)) return;
      list.push_back(both);
      const auto [x, y, z] = both.shift;
      if (!problem_.half) list.push_back({both.second, both.first, {-x, -y, -z}});
      return;
    }
    const PointImage& image = plan_.images()[pair.second - looking_];
    if (image.system != system) return;
    const ListedPair one{pair.first, image.point, plan_.shift_of(pair.first, image.point, image.shift)};
    const bool of_other_half = one.first > one.second || (one.first == one.second && one.shift < Shift{});
    if (problem_.half && of_other_half) return;
    if (accepts(one, system)) list.push_back(one);
  }

 private:
  bool accepts(const ListedPair& pair, uint32_t system) const {
    return is_within_reach(problem_, problem_.boxes[system], pair) && !excluded_.has(pair);
  }

  const ListProblem& problem_;
  const ListPlan& plan_;
  const uint64_t looking_;
  const Exclusions excluded_;
};

std::vector<ListedPair> joined(const std::vector<std::vector<ListedPair>>& parts) {
  std::vector<size_t> starts = {0};
  for (const std::vector<ListedPair>& part : parts) starts.push_back(starts.back() + part.size());
  std::vector<ListedPair> list(starts.back());
#pragma omp parallel for schedule(dynamic, 1) if (parts.size() > 1)
  for (size_t k = 0; k < parts.size(); ++k) std::ranges::copy(parts[k], list.begin() + int64_t(starts[k]));
  return list;
}

bool in_order(const std::vector<ListedPair>& list) {
  bool ascending = true;
#pragma omp parallel for schedule(static) reduction(&& : ascending) if (int64_t(list.size()) > share_from)
  for (size_t k = 1; k < list.size(); ++k) ascending = ascending && list[k - 1] <= list[k];
  return ascending;
}

// By first through counting, each first's by the rest. Half lists of open boxes come in order from the search.
std::vector<ListedPair> sorted(std::vector<ListedPair> list, uint64_t firsts) {
  if (in_order(list)) return list;
  const std::vector<int64_t> offsets = offsets_of(list, firsts);
  std::vector<int64_t> next(offsets.begin(), offsets.end() - 1);
  std::vector<ListedPair> in_order(list.size());
  for (const ListedPair& pair : list) in_order[next[pair.first]++] = pair;
#pragma omp parallel for schedule(dynamic, 256) if (int64_t(list.size()) > share_from)
  for (int64_t i = 0; i < int64_t(firsts); ++i)
    std::sort(in_order.begin() + offsets[i], in_order.begin() + offsets[i + 1]);
  return in_order;
}

}  // namespace

std::vector<int64_t> offsets_of(const std::vector<ListedPair>& list, uint64_t firsts) {
  std::vector<int64_t> offsets(firsts + 1, 0);
  for (const ListedPair& pair : list) ++offsets[pair.first + 1];
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  return offsets;
}

std::vector<ListedPair> list_pairs(Search& search, const ListProblem& problem, CollideOptions options) {
  check_problem(problem);
  if (options.method == Method::automatic) {
    if (Device* device = search.device(); device && device->capabilities().makes_lists)
      if (const auto list = DeviceLists(*device).list(problem)) return list->pairs();
    if (const int threads = list_threads(search))
      if (PairRows list; HostLists(threads).list(problem, true, list)) return list.pairs();
  }
  return list_by_search(search, problem, options).pairs();
}

int list_threads(const Search& search) {
  return search.info().on_host ? std::stoi(search.info().details.at("threads")) : 0;
}

PairRows list_by_search(Search& search, const ListProblem& problem, CollideOptions options) {
  options.want_pairs = true;
  const ListPlan plan(problem);
  const std::vector<Pair> pairs = colliding_pairs(search, list_spheres(problem, plan), options);
  const Lister lister(problem, plan);
  constexpr size_t share = 1 << 16, ahead = 16;  // pairs
  const auto shares = int64_t((pairs.size() + share - 1) / share);
  std::vector<std::vector<ListedPair>> parts(shares);
  TeamErrors errors;
#pragma omp parallel for schedule(dynamic, 1) if (shares > 1)
  for (int64_t k = 0; k < shares; ++k)
    errors.run(uint64_t(k), [&] {
      const size_t end = std::min((size_t(k) + 1) * share, pairs.size());
      parts[k].reserve((problem.half ? 1 : 2) * share);
      for (size_t p = size_t(k) * share; p < end; ++p) {
        lister.prefetch(pairs[std::min(p + ahead, end - 1)]);
        lister.add(pairs[p], parts[k]);
      }
    });
  errors.rethrow();
  std::vector<ListedPair> list = joined(parts);
  if (problem.self_pairs) lister.add_points_themselves(list);
  return rows_of(sorted(std::move(list), problem.firsts().size()), problem.firsts().size());
}

}  // namespace spherepair
