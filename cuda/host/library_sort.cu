// SPDX-License-Identifier: MIT
#include "cuda/host/library_sort.h"

#include <thrust/binary_search.h>
#include <thrust/device_ptr.h>
#include <thrust/execution_policy.h>
#include <thrust/fill.h>
#include <thrust/iterator/counting_iterator.h>
#include <thrust/sequence.h>
#include <thrust/sort.h>
#include <thrust/transform.h>

#include <map>
#include <utility>

#include "common/shared/cell.h"
#include "cuda/host/check.h"

namespace spherepair {
namespace {

struct SlotOf {
  GridParams grid;
  __device__ uint operator()(vec4 sphere) const { return slot_of(sphere, grid); }
};

// Returns sphere i; with in_radii its radius is replaced by i.
struct Named {
  const vec4* position;
  bool in_radii;
  __device__ vec4 operator()(uint i) const {
    vec4 sphere = position[i];
    if (in_radii) sphere.w = bits_float(i);
    return sphere;
  }
};

}  // namespace

// Thrust's allocator: it hands freed blocks out again.
class LibrarySort::Memory {
 public:
  using value_type = char;
  uint64_t allocations = 0;
  ~Memory() {
    for (const auto& [bytes, block] : free_) cudaFree(block);
    for (const auto& [block, bytes] : taken_) cudaFree(block);
  }
  char* allocate(std::ptrdiff_t bytes) {
    auto found = free_.lower_bound(size_t(bytes));
    void* block = nullptr;
    size_t size = size_t(bytes);
    if (found != free_.end()) {
      size = found->first, block = found->second;
      free_.erase(found);
    } else {
      cuda_check(cudaMalloc(&block, size), "allocating temporary memory of a library");
      ++allocations;
    }
    taken_[block] = size;
    return static_cast<char*>(block);
  }
  void deallocate(char* block, size_t) {
    const auto found = taken_.find(block);
    free_.emplace(found->second, found->first);
    taken_.erase(found);
  }

 private:
  std::multimap<size_t, void*> free_;
  std::map<void*, size_t> taken_;
};

LibrarySort::LibrarySort() : memory_(std::make_unique<Memory>()) {}
LibrarySort::~LibrarySort() = default;
uint64_t LibrarySort::take_allocations() { return std::exchange(memory_->allocations, 0); }

void LibrarySort::sort(const Params& p, const vec4* position, uint* table, vec4* sorted, uint* id, uint* sorted_count) {
  const auto policy = thrust::cuda::par_nosync(*memory_);
  const uint n = p.n;
  char* block = memory_->allocate(std::ptrdiff_t(n * sizeof(uint)));
  const thrust::device_ptr<uint> slots(reinterpret_cast<uint*>(block)), ids(id), counts(sorted_count), cells(table);
  const thrust::device_ptr<const vec4> spheres(position);
  const thrust::counting_iterator<uint> first_slot(0);
  thrust::transform(policy, spheres, spheres + n, slots, SlotOf{p.grid});
  thrust::sequence(policy, ids, ids + n);
  thrust::sort_by_key(policy, slots, slots + n, ids);
  const Named named{position, p.sort.index_in_w != 0u};
  thrust::transform(policy, ids, ids + n, thrust::device_ptr<vec4>(sorted), named);
  thrust::fill(policy, counts, counts + n, 0u);
  thrust::lower_bound(policy, slots, slots + n, first_slot, first_slot + p.grid.cell_slots + 1, cells);
  memory_->deallocate(block, n * sizeof(uint));
}

}  // namespace spherepair
