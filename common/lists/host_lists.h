// SPDX-License-Identifier: MIT
// Lists of pairs made by the host's threads: each point's row in one go, through cells or, of small systems, without.
// Most pairs are decided in float32 with the bound of its roundings, the rest by displacement.h.
#pragma once

#include <array>

#include "common/cpu/search/cpu_grid_sort.h"
#include "common/lists/host_system.h"
#include "common/lists/pair_rows.h"

namespace spherepair {

// Keeps its memory from list to list.
class HostLists {
 public:
  explicit HostLists(int threads, const RowSimd& simd = row_simds().front());

  // Makes the list of a checked problem; with_shifts: else all shifts are left out. False where cells are of no use, so
  // that the search is faster: points or radii of a large system differ too much in density or size. Throws ListError
  // as ListPlan does.
  bool list(const ListProblem& problem, bool with_shifts, PairRows& list);

 private:
  static constexpr uint lookers_at_once = 8;
  struct Row {
    const uint* keys;
    uint count;
  };
  class Arena {
   public:
    void clear() { block_ = used_ = 0; }
    uint* room(size_t keys);
    void use(size_t keys) { used_ += keys; }

   private:
    std::vector<Buffer<uint>> blocks_;
    size_t block_ = 0, used_ = 0;
  };
  struct Worker {  // what a thread needs
    Arena rows;
    RowBlock block;
    Buffer<uint> own;  // where in the block a small system's points are
    CellSort cells{grid_simds().front()}, looking_cells{grid_simds().front()};
    Buffer<vec4> spheres, looking_spheres;
    Buffer<uint> keys;
  };
  struct Group {  // those whose rows are looked for at once
    uint count = 0;
    std::array<uint, lookers_at_once> numbers;
    std::array<RowPoint, lookers_at_once> points;
    void add(uint i, const RowPoint& point) { numbers[count] = i, points[count++] = point; }
  };
  struct Cells;

  bool look_beside(const std::vector<HostSystem>& systems, const std::vector<size_t>& some);
  bool look(const HostSystem& system, Worker& worker, int threads);
  void look_through_all(const HostSystem& system, Worker& worker);
  bool look_through_cells(const HostSystem& system, Worker& worker, int threads);
  void look_from(const HostSystem& system, const Cells& cells, Chunk places, Worker& worker);
  void add_rows(const HostSystem& system, const Group& group, uint first, bool in_order, Worker& worker);
  void write(const ListPlan& plan, const std::vector<HostSystem>& systems, bool with_shifts, PairRows& list) const;

  const int threads_;
  const RowSimd& simd_;
  std::vector<Worker> workers_;
  Buffer<Row> rows_;  // of each that looks
  const Exclusions* excluded_ = nullptr;
};

}  // namespace spherepair
