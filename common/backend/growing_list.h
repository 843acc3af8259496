// SPDX-License-Identifier: MIT
// Lists of pairs that threads fill. A list that finds no memory stops growing, as no exception may leave a parallel
// region.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <vector>

namespace spherepair {

// Whether the system has this many bytes free without ending a process; true if the system does not say.
bool fits_in_memory(uint64_t bytes);

// Throws BackendError: memory has no room for a list of so many colliding pairs.
[[noreturn]] void fail_for_list(uint64_t pairs);

template <typename T>
class GrowingList {
 public:
  void append(const T* first, size_t count) {
    if (values_.size() + count > values_.capacity() && !grow(count)) [[unlikely]]
      return;
    values_.insert(values_.end(), first, first + count);
  }
  void clear() {
    values_.clear();
    complete_ = true;
  }
  bool complete() const { return complete_; }  // false: memory ran out, and the list is empty
  std::span<const T> values() const { return values_; }

 private:
  bool grow(size_t count) {
    constexpr size_t least = 1024;
    const size_t wanted = std::max({least, 2 * values_.capacity(), values_.size() + count});
    complete_ = complete_ && fits_in_memory(wanted * sizeof(T));
    try {
      if (complete_) values_.reserve(wanted);
    } catch (const std::bad_alloc&) {
      complete_ = false;
    }
    if (!complete_) values_ = {};
    return complete_;
  }

  std::vector<T> values_;
  bool complete_ = true;
};

// Runs join(), which copies the lists of all `pairs` that the threads found. Throws BackendError if memory has no room
// for the copies, or had none for the lists.
template <typename T, typename Join>
void join_lists(std::span<const GrowingList<T>> lists, uint64_t pairs, uint64_t bytes_of_copies, Join join) {
  const bool complete = std::ranges::all_of(lists, [](const GrowingList<T>& list) { return list.complete(); });
  if (!complete || !fits_in_memory(bytes_of_copies)) fail_for_list(pairs);
  try {
    join();
  } catch (const std::bad_alloc&) {
    fail_for_list(pairs);
  }
}

// Returns all values that the threads found, sorted.
template <typename T>
std::vector<T> joined(std::span<const GrowingList<T>> lists, uint64_t pairs) {
  std::vector<T> all;
  join_lists<T>(lists, pairs, sizeof(T) * pairs, [&] {
    for (const GrowingList<T>& list : lists) all.insert(all.end(), list.values().begin(), list.values().end());
  });
  std::ranges::sort(all);
  return all;
}

}  // namespace spherepair
