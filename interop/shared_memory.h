// SPDX-License-Identifier: MIT
// Memory that CUDA allocates and OpenGL imports, through a file descriptor.
#pragma once

#include <epoxy/gl.h>

#include <cstdint>

#include "glsl/driver_memory.h"

namespace spherepair {

class SharedMemory {
 public:
  // On the current CUDA device, for the current OpenGL context. Throws BackendError naming the call that failed.
  explicit SharedMemory(uint64_t bytes);
  ~SharedMemory();
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;

  void* address() const { return reinterpret_cast<void*>(address_); }  // CUDA's
  GLuint buffer() const { return storage_.buffer; }
  uint64_t bytes() const { return bytes_; }

 private:
  SharedMemory() = default;  // so that a constructor that fails gives back what it has
  void allocate(uint64_t bytes);
  void import();

  uint64_t bytes_ = 0, address_ = 0, handle_ = 0;
  BufferStorage storage_;
};

}  // namespace spherepair
