// SPDX-License-Identifier: MIT
#include "common/lists/host_lists.h"

#include <omp.h>

#include <algorithm>

#include "common/backend/cpu_team.h"
#include "common/plan/dense_plan.h"
#include "common/shared/cell.h"

namespace spherepair {
namespace {

constexpr uint64_t few_tests = 1 << 18, few_points = 64;  // for which cells do not pay

bool is_small(const HostSystem& system) {
  const uint64_t looking = system.looking(), targets = system.targets();
  return looking * targets <= few_tests || std::min(looking, targets) <= few_points;
}

GridPlan plan_of(const HostSystem& system) {
  Extent extent;
  for (size_t axis = 0; axis < 3; ++axis) extent.low[axis] = system.low(axis), extent.high[axis] = system.high(axis);
  extent.smallest = extent.largest = system.reach() / 2;
  return dense_plan(extent, system.targets());
}

// Whether most points share a cell with many others although it is far wider than their reach.
bool is_crowded(const HostSystem& system, const GridPlan& plan, const CellOrder& order) {
  if (plan.side <= 2 * system.reach() || plan.slots == 1) return false;
  uint64_t tests = 0;
  for (uint slot = 0; slot < plan.slots; ++slot) {
    const uint64_t count = order.begin[slot + 1] - order.begin[slot];
    tests += count * count;
  }
  return tests > 64 * system.targets();
}

}  // namespace

uint* HostLists::Arena::room(size_t keys) {
  constexpr size_t first_block = 1 << 14, block = 1 << 20;  // keys
  for (; block_ < blocks_.size(); ++block_, used_ = 0)
    if (used_ + keys <= blocks_[block_].size()) return blocks_[block_].data() + used_;
  blocks_.emplace_back().resize(std::max(keys, blocks_.size() == 1 ? first_block : block));
  return blocks_.back().data();
}

struct HostLists::Cells {
  GridParams grid;
  CellOrder looking;
  RowTargets targets;
  const uint* begin;  // of each cell's targets
};

HostLists::HostLists(int threads, const RowSimd& simd) : threads_(threads), simd_(simd), workers_(size_t(threads)) {}

bool HostLists::list(const ListProblem& problem, bool with_shifts, PairRows& list) {
  const ListPlan plan(problem);
  const Exclusions excluded(problem);
  excluded_ = &excluded;
  rows_.resize(problem.firsts().size());
  for (Worker& worker : workers_) worker.rows.clear();
  std::vector<HostSystem> systems;
  systems.reserve(plan.ranges().size());
  std::vector<size_t> others;
  for (size_t b = 0; b < plan.ranges().size(); ++b) {
    const HostSystem& system = systems.emplace_back(problem, plan, b);
    if (!system.fits_keys()) return false;
    if (int64_t(system.targets()) <= share_from && plan.ranges().size() > 1)
      others.push_back(b);
    else if (!look(system, workers_[0], threads_))
      return false;
  }
  if (!look_beside(systems, others)) return false;
  write(plan, systems, with_shifts, list);
  return true;
}

// Looks through each of these systems with one thread.
bool HostLists::look_beside(const std::vector<HostSystem>& systems, const std::vector<size_t>& some) {
  if (some.empty()) return true;
  TeamErrors errors;
  bool listed = true;
#pragma omp parallel for num_threads(team_of(some.size(), threads_)) schedule(dynamic, 1) reduction(&& : listed)
  for (size_t k = 0; k < some.size(); ++k)
    errors.run(k, [&] { listed = look(systems[some[k]], workers_[size_t(omp_get_thread_num())], 1) && listed; });
  errors.rethrow();
  return listed;
}

// Finds the rows of a system. False: cells are of no use.
bool HostLists::look(const HostSystem& system, Worker& worker, int threads) {
  if (!is_small(system)) return look_through_cells(system, worker, threads);
  look_through_all(system, worker);
  return true;
}

void HostLists::look_through_all(const HostSystem& system, Worker& worker) {
  const auto targets = uint(system.targets()), points = uint(system.points());
  RowBlock& block = worker.block;
  block.make_room(targets), worker.own.resize(points);
  uint point = 0, image = points;
  for (uint at = 0; at < targets; ++at) {  // in order of keys
    const bool own = point < points && (image == targets || system.key(point) < system.key(image));
    const uint next = own ? point++ : image++;
    const vec4 target = system.target(next);
    block.x[at] = target.x, block.y[at] = target.y, block.z[at] = target.z, block.radius[at] = target.w;
    block.key[at] = system.key(next);
    if (own) worker.own[next] = at;
  }
  block.end(targets);
  for (uint i = 0; i < system.looking();) {
    const uint first = system.is_half() ? worker.own[i] : 0;
    Group group;
    for (; i < system.looking() && group.count < lookers_at_once; ++i)
      group.add(i, system.row_point(i, system.looker(i)));
    add_rows(system, group, first, true, worker);
  }
}

// The group's rows among the targets in worker.block.
void HostLists::add_rows(const HostSystem& system, const Group& group, uint first, bool in_order, Worker& worker) {
  std::array<FoundRow, lookers_at_once> found;
  uint* keys = worker.rows.room(size_t(group.count) * worker.block.count + row_slack);
  simd_.find(worker.block, first, in_order, std::span(group.points).first(group.count), system.limits(), keys,
             found.data());
  const uint* const begin = keys;
  for (uint p = 0; p < group.count; ++p) {
    const uint i = group.numbers[p];
    uint count = found[p].count;
    const auto keep = [&](auto kept) {
      count = uint(std::remove_if(keys, keys + count, [&](uint key) { return !kept(system.pair(i, key)); }) - keys);
    };
    if (found[p].open) keep([&](const ListedPair& pair) { return system.is_within_reach(pair); });
    if (!excluded_->empty()) keep([&](const ListedPair& pair) { return !excluded_->has(pair); });
    rows_[system.first_looking() + i] = {keys, count};
    keys += found[p].count;
  }
  worker.rows.use(size_t(keys - begin));
}

bool HostLists::look_through_cells(const HostSystem& system, Worker& worker, int threads) {
  const System& range = system.range();
  if (system.sized() && range.reach > 2 * range.mean_reach) return false;
  const GridPlan plan = plan_of(system);
  Cells cells;
  cells.grid = grid_params(plan);
  const auto sorted = [&](CellSort& sort, Buffer<vec4>& spheres, uint64_t count, auto sphere) {
    spheres.resize(count);
    in_shares(0, int64_t(count), [&](int64_t begin, int64_t end) {
      for (int64_t k = begin; k < end; ++k) spheres[size_t(k)] = sphere(uint64_t(k));
    });
    sort.sort({spheres.data(), count}, cells.grid, system.sized(), threads);
    return sort.order();
  };
  const uint64_t count = system.targets();
  const CellOrder order = sorted(worker.cells, worker.spheres, count, [&](uint64_t k) { return system.target(k); });
  if (is_crowded(system, plan, order)) return false;
  const uint* keys = order.id;
  if (!system.keys_are_numbers()) {
    worker.keys.resize(count);
    in_shares(0, int64_t(count), [&](int64_t begin, int64_t end) {
      for (int64_t k = begin; k < end; ++k) worker.keys[size_t(k)] = system.key(order.id[k]);
    });
    keys = worker.keys.data();
  }
  cells.targets = {order.x, order.y, order.z, order.radius, keys};
  cells.begin = order.begin;
  const bool asks = system.points() == 0;
  cells.looking = !asks ? order
                        : sorted(worker.looking_cells, worker.looking_spheres, system.looking(),
                                 [&](uint64_t i) { return system.looker(i); });
  const std::vector<Chunk> chunks = (asks ? worker.looking_cells : worker.cells).chunks(threads);
  TeamErrors errors;
#pragma omp parallel for num_threads(team_of(chunks.size(), threads)) schedule(dynamic, 1)
  for (size_t k = 0; k < chunks.size(); ++k)
    errors.run(
        k, [&] { look_from(system, cells, chunks[k], threads > 1 ? workers_[size_t(omp_get_thread_num())] : worker); });
  errors.rethrow();
  return true;
}

// Lookers beside each other in a row of cells, at most eight, share their ranges of targets: no two cells next to each
// other are nearer than the reach.
void HostLists::look_from(const HostSystem& system, const Cells& cells, Chunk places, Worker& worker) {
  const CellOrder& looking = cells.looking;
  const GridParams& grid = cells.grid;
  const auto position = [&](uint place) {
    return grid_position({looking.x[place], looking.y[place], looking.z[place], 0}, grid);
  };
  const auto below = [](float coordinate) { return uint(std::max(int(coordinate) - 1, 0)); };
  const auto above = [](float coordinate, uint cells) { return std::min(uint(coordinate) + 1, cells - 1); };
  for (uint first = places.first; first < places.last;) {
    const GridPosition at = position(first);
    const uint row = dense_slot(0, uint(at.y), uint(at.z), grid);
    const uint last = std::min({places.last, looking.begin[row + grid.cells_x], first + lookers_at_once});
    const uint left = below(at.x), right = above(position(last - 1).x, grid.cells_x);
    std::array<TargetRange, 9> ranges;
    size_t filled = 0;
    for (uint z = below(at.z); z <= above(at.z, grid.cells_z); ++z)
      for (uint y = below(at.y); y <= above(at.y, grid.cells_y); ++y) {
        const uint slot = dense_slot(0, y, z, grid);
        const TargetRange range = {cells.begin[slot + left], cells.begin[slot + right + 1]};
        if (range.first < range.last) ranges[filled++] = range;
        __builtin_prefetch(&cells.begin[slot + right + 20]);
      }
    Group group;
    for (; first < last; ++first) {
      const uint i = looking.id[first];
      if (i >= system.looking()) continue;  // an image
      const float radius = looking.radius ? looking.radius[first] : 0;
      group.add(i, system.row_point(i, {looking.x[first], looking.y[first], looking.z[first], radius}));
    }
    simd_.collect(cells.targets, std::span(ranges).first(filled), system.sized(), worker.block);
    add_rows(system, group, 0, false, worker);
  }
}

void HostLists::write(const ListPlan& plan, const std::vector<HostSystem>& systems, bool with_shifts,
                      PairRows& list) const {
  const auto firsts = int64_t(rows_.size());
  list.offsets.resize(size_t(firsts) + 1);
  in_shares(0, firsts, [&](int64_t begin, int64_t end) {
    for (int64_t i = begin; i < end; ++i) list.offsets[size_t(i) + 1] = rows_[size_t(i)].count;
  });
  list.make_room(with_shifts && !plan.is_open());
  list.in_rows([&](int64_t begin, int64_t end) {
    constexpr int64_t ahead = 16;
    for (int64_t i = begin; i < end; ++i) {
      __builtin_prefetch(rows_[size_t(std::min(i + ahead, firsts - 1))].keys);
      const HostSystem& system = systems[plan.systems()[uint64_t(i)]];
      const Row& row = rows_[size_t(i)];
      const auto from = size_t(list.offsets[size_t(i)]);
      for (uint k = 0; k < row.count; ++k) list.second[from + k] = system.second_of(row.keys[k]);
      for (uint k = 0; list.shifted && k < row.count; ++k)
        list.shifts[from + k] = system.pair(uint64_t(i) - system.first_looking(), row.keys[k]).shift;
    }
  });
}

}  // namespace spherepair
