// SPDX-License-Identifier: MIT
// Memory for the CPU's grid: kept between calls, never cleared, in large pages if the system has them. Scattered writes
// to small pages are slowed by address translation, and first touches of pages by the operating system.
#pragma once

#include <sys/mman.h>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>
#include <vector>

namespace spherepair {

constexpr size_t small_page = 4096, large_page = 2 << 20;  // bytes

// Asks for large pages. A failure only costs time.
inline void advise_large_pages(void* memory, size_t bytes) {
  const size_t begin = (reinterpret_cast<uintptr_t>(memory) + small_page - 1) / small_page * small_page;
  const size_t end = (reinterpret_cast<uintptr_t>(memory) + bytes) / small_page * small_page;
  if (begin + large_page <= end) madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
}

template <typename T>
void reserve_large(std::vector<T>& values, size_t n) {
  values.reserve(n);
  advise_large_pages(values.data(), values.capacity() * sizeof(T));
}

// Memory that stays allocated when it shrinks and is never cleared.
template <typename T>
class Buffer {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  // Makes room for n values, and for reading a whole vector after them. Growing loses the contents.
  void resize(size_t n) {
    const size_t needed = n * sizeof(T) + slack, page = needed < large_page ? small_page : large_page;
    const size_t bytes = (needed + page - 1) / page * page;
    if (bytes > bytes_) {
      data_.reset();
      size_ = bytes_ = 0;  // in case of an error
      data_.reset(static_cast<T*>(std::aligned_alloc(page, bytes)));
      if (!data_) throw std::bad_alloc();
      bytes_ = bytes;
      advise_large_pages(data_.get(), bytes);
    }
    size_ = n;
  }

  T* data() { return data_.get(); }
  const T* data() const { return data_.get(); }
  size_t size() const { return size_; }
  T& operator[](size_t i) { return data_.get()[i]; }
  const T& operator[](size_t i) const { return data_.get()[i]; }

 private:
  static constexpr size_t slack = 64;  // bytes
  struct Free {
    void operator()(T* p) const { std::free(p); }
  };
  std::unique_ptr<T, Free> data_;
  size_t size_ = 0, bytes_ = 0;
};

}  // namespace spherepair
