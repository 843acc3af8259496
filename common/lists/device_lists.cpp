// SPDX-License-Identifier: MIT
#include "common/lists/device_lists.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "common/lists/list_systems.h"

namespace spherepair {

void DeviceLists::launch(Kernel kernel, uint block, uint64_t groups, const Variant& variant) {
  context_.launch({.kernel = kernel, .block = block, .variant = variant, .groups = folded(groups)});
}

bool DeviceLists::is_ready(const ListProblem& problem, uint wanted, int64_t room) const {
  const auto has_memory = [&](const auto& column) { return context_.buffers.bytes(column.first) >= column.second; };
  return device_problem(problem).equals(sent_) && (sent_.state.flags & list_columns) == wanted &&
         sent_.state.room == room && std::ranges::all_of(column_sizes(wanted, room), has_memory);
}

bool DeviceLists::grow(std::span<const std::pair<uint, uint64_t>> slots) {
  bool grown = false;
  for (const auto& [slot, bytes] : slots) grown |= context_.buffers.grow(slot, std::max<uint64_t>(bytes, 16));
  return grown;
}

bool DeviceLists::make_room() {
  const ListState& state = sent_.state;
  context_.n = uint64_t(state.points) + state.queries;
  context_.params.sort.scan_tiles = uint(ceil_div(uint64_t(state.points) + state.systems + 2, SCAN_TILE));
  context_.buffers.set_spheres(std::max<uint64_t>(context_.n, 1));
  const uint64_t looking = state.looking, points = state.points, tiles = context_.params.sort.scan_tiles;
  const std::pair<uint, uint64_t> needed[] = {{SLOT_LIST_STATE, sizeof(ListState)},
                                              {SLOT_LIST_SYSTEM, state.systems * sizeof(ListSystem)},
                                              {SLOT_LIST_EXCLUDED, state.exclusions * sizeof(uvec2)},
                                              {SLOT_LIST_GIVEN, context_.n * sizeof(dvec4)},
                                              {SLOT_LIST_PLACE, context_.n * sizeof(ivec4)},
                                              {SLOT_SORTED, context_.n * sizeof(vec4)},
                                              {SLOT_ID, points * sizeof(uint)},
                                              {SLOT_LIST_BIN, points * sizeof(uvec2)},
                                              {SLOT_LIST_KEY, looking * state.kept * sizeof(uint)},
                                              {SLOT_ROW_LENGTH, looking * sizeof(uint)},
                                              {SLOT_LIST_BEGIN, (looking + 1) * sizeof(int64_t)},
                                              {SLOT_LIST_SUM, ceil_div(looking, LIST_TILE) * sizeof(uint64_t)},
                                              {SLOT_CELL, tiles * SCAN_TILE * sizeof(uint)},
                                              {SLOT_SCAN, (tiles + 1) * sizeof(uint)},
                                              {SLOT_LIST_LOOK, looking * sizeof(ListLook)},
                                              {SLOT_LIST_LONG, row_groups() * sizeof(uint)}};
  return grow(needed);
}

bool DeviceLists::begin(const ListProblem& problem) {
  DeviceProblem told = device_problem(problem);
  const bool known = told.equals(sent_);
  if (!known) {
    sent_ = std::move(told);
    long_rows_ = false;
    keep_more(context_.buffers.memory(SLOT_LIST_KEY).bytes / sizeof(uint) * 3 / 5);  // as set_columns() made room for
  }
  if (!make_room() && known) return true;
  context_.buffers.write(SLOT_LIST_SYSTEM, sent_.systems);
  context_.buffers.write(SLOT_LIST_EXCLUDED, sent_.exclusions);
  context_.buffers.write(SLOT_LIST_STATE, &sent_.state, 0, sizeof(ListState));
  return false;
}

// Lets list_count keep so many keys in all, an equal number for each row, as far as kernels can number them.
void DeviceLists::keep_more(uint64_t keys) {
  const uint64_t most = std::min(context_.device.capabilities().largest_buffer / sizeof(uint), uint64_t(1) << 32) / 2;
  const uint64_t rows = std::max<uint64_t>(looking(), 1);
  sent_.state.kept = uint(std::min(std::max(uint64_t(sent_.state.kept), keys / rows), most / rows));
}

std::array<std::pair<uint, uint64_t>, 4> DeviceLists::column_sizes(uint wanted, int64_t room) const {
  const auto bytes = [&](uint flag, uint64_t each) { return wanted & flag ? uint64_t(room) * each : 0; };
  return {{{SLOT_LIST_KEY, (looking() * sent_.state.kept + uint64_t(room)) * sizeof(uint)},
           {SLOT_LIST_FIRST, bytes(LIST_WANTS_FIRST, sizeof(uint))},
           {SLOT_LIST_SECOND, bytes(LIST_WANTS_SECOND, sizeof(uint))},
           {SLOT_LIST_SHIFT, bytes(LIST_WANTS_SHIFTS, 3 * sizeof(int))}}};
}

bool DeviceLists::set_columns(uint wanted, int64_t room) {
  const uint kept = sent_.state.kept;
  const uint64_t key_bytes = context_.buffers.memory(SLOT_LIST_KEY).bytes;
  keep_more(uint64_t(room) * 3 / 2);
  long_rows_ = uint64_t(room) >= looking() * LIST_LONG;
  bool grown = grow(column_sizes(wanted, room));
  if (sent_.state.kept != kept || context_.buffers.memory(SLOT_LIST_KEY).bytes != key_bytes)
    grown = counts_again_ = true;
  const uint flags = (sent_.state.flags & ~list_columns) | wanted;
  if (!grown && sent_.state.flags == flags && sent_.state.room == room) return true;
  sent_.state.flags = flags;
  sent_.state.room = room;
  // The rest of the state is the kernels' by now.
  context_.buffers.write(SLOT_LIST_STATE, &sent_.state.room, offsetof(ListState, room), sizeof(int64_t));
  context_.buffers.write(SLOT_LIST_STATE, &sent_.state.flags, offsetof(ListState, flags), sizeof(uint));
  context_.buffers.write(SLOT_LIST_STATE, &sent_.state.kept, offsetof(ListState, kept), sizeof(uint));
  return false;
}

void DeviceLists::prepare_small_systems() {
  context_.buffers.clear(SLOT_LIST_STATE, offsetof(ListState, kept));  // nothing found yet
  launch(Kernel::list_prepare, LIST_PREPARE_BLOCK, sent_.state.systems);
}

void DeviceLists::prepare_systems() {
  const uint tiles = context_.params.sort.scan_tiles;
  const uint64_t words = std::max<uint64_t>(tiles * SCAN_TILE, sent_.state.systems * LIST_EXTREMES);
  launch(Kernel::list_clear, SERVICE_BLOCK, ceil_div(words, SERVICE_BLOCK));
  launch(Kernel::list_measure, SERVICE_BLOCK, ceil_div(context_.n, SERVICE_BLOCK * LIST_EACH));
  launch(Kernel::list_plan, SERVICE_BLOCK, ceil_div(sent_.state.systems, SERVICE_BLOCK));
  launch(Kernel::list_bin, SERVICE_BLOCK, ceil_div(sent_.state.points, SERVICE_BLOCK));
  if (tiles > 1) launch(Kernel::grid_sums, SCAN_BLOCK, tiles);
  launch(Kernel::grid_scan, SCAN_BLOCK, tiles);
  launch(Kernel::list_scatter, SERVICE_BLOCK, ceil_div(sent_.state.points, SERVICE_BLOCK));
  launch(Kernel::list_look, SERVICE_BLOCK, ceil_div(context_.n, SERVICE_BLOCK));
}

void DeviceLists::count() {
  counts_again_ = false;
  if (is_empty()) return context_.buffers.clear(SLOT_LIST_BEGIN, (looking() + 1) * sizeof(int64_t));
  sent_.is_small() ? prepare_small_systems() : prepare_systems();
  const uint64_t row_tiles = ceil_div(looking(), LIST_TILE);
  launch(Kernel::list_count, row_block(), row_groups(), {.long_rows = long_rows_});
  if (row_tiles > 1) launch(Kernel::list_sums, SCAN_BLOCK, row_tiles);
  launch(Kernel::list_scan, SCAN_BLOCK, row_tiles);
}

DeviceLists::Found DeviceLists::found() {
  Found found;
  ListState state;
  context_.buffers.read(SLOT_LIST_STATE, &state, 0, sizeof(ListState));
  context_.buffers.read(SLOT_LIST_BEGIN, &found.pairs, looking() * sizeof(int64_t), sizeof(int64_t));
  if (state.wrong) found.wrong = ~state.wrong;
  if (state.far) found.far = ~state.far;
  found.wide = state.wide != 0;
  return found;
}

void DeviceLists::fill() {
  if (is_empty()) return;  // nothing was counted
  if (counts_again_) count();
  launch(Kernel::list_find, row_block(), std::min<uint64_t>(row_groups(), LIST_LONG_GROUPS));
  launch(Kernel::list_order, LIST_ORDER_BLOCK, ceil_div(looking(), 1u << sent_.state.order_bits));
}

void DeviceLists::write_points(const ListProblem& problem) {
  std::vector<dvec4> given(context_.n);
  const auto write = [&](const PointSet& set, int64_t first) {
#pragma omp parallel for schedule(static) if (int64_t(set.size()) > share_from)
    for (int64_t i = 0; i < int64_t(set.size()); ++i) {
      const auto& [x, y, z] = set.points[size_t(i)];
      given[size_t(first + i)] = {x, y, z, set.radii.empty() ? 0 : set.radii[size_t(i)]};
    }
  };
  write(problem.set, 0);
  if (problem.asks) write(problem.queries, int64_t(problem.set.size()));
  context_.buffers.write(SLOT_LIST_GIVEN, given);
}

PairRows DeviceLists::read_list(uint64_t pairs) {
  PairRows list;
  list.offsets = context_.buffers.read<int64_t>(SLOT_LIST_BEGIN, uint64_t(sent_.state.looking) + 1);
  list.second.resize(pairs), list.shifts.resize(pairs), list.shifted = true;
  context_.buffers.read(SLOT_LIST_SECOND, list.second.data(), 0, pairs * sizeof(uint));
  context_.buffers.read(SLOT_LIST_SHIFT, list.shifts.data(), 0, pairs * sizeof(Shift));
  return list;
}

void DeviceLists::refuse(const Found& found) {
  const uint64_t points = sent_.state.points;
  if (const auto i = found.wrong) {
    dvec4 given;
    context_.buffers.read(SLOT_LIST_GIVEN, &given, *i * sizeof(dvec4), sizeof(dvec4));
    const bool query = *i >= points;
    refuse_point(query ? "queries" : "positions", query ? "query_radii" : "radii", query ? *i - points : *i,
                 {given.x, given.y, given.z}, given.w);
  }
  if (const auto i = found.far) throw *i < points ? too_far("positions", *i) : too_far("queries", *i - points);
  throw ListError(
      ListFault::range,
      "the reach spans so many boxes that their images of all points are more than 2^32: take a larger box, "
      "or copy the positions to the host");
}

std::optional<PairRows> DeviceLists::list(const ListProblem& problem) {
  PairRows none;
  none.offsets.resize(problem.firsts().size() + 1);
  if (problem.set.size() == 0 || problem.firsts().size() == 0) return none;
  const uint64_t largest = context_.device.capabilities().largest_buffer;
  if ((problem.set.size() + problem.queries.size()) * sizeof(ListLook) > largest) return std::nullopt;
  begin(problem);
  write_points(problem);
  count();
  const Found counted = found();
  if (counted.wide || uint64_t(counted.pairs) * sizeof(Shift) > largest) return std::nullopt;
  if (counted.far) refuse(counted);
  if (counted.pairs == 0) return none;
  set_columns(LIST_WANTS_SECOND | LIST_WANTS_SHIFTS, counted.pairs);
  fill();
  return read_list(uint64_t(counted.pairs));
}

}  // namespace spherepair
