// SPDX-License-Identifier: MIT
// Memory that CUDA allocates and OpenGL imports through a file descriptor.
#pragma once

#include <epoxy/gl.h>

#include <cstdint>

#include "glsl/driver_memory.h"

namespace spherepair {

class SharedMemory {
 public:
  // Allocates on the current CUDA device for the current OpenGL context. Throws BackendError naming the failed call.
  explicit SharedMemory(uint64_t bytes);
  ~SharedMemory();
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;

  void* address() const { return reinterpret_cast<void*>(address_); }  // in CUDA
  GLuint buffer() const { return storage_.buffer; }
  uint64_t bytes() const { return bytes_; }

 private:
  SharedMemory() = default;  // so that the destructor runs if the other constructor throws
  void allocate(uint64_t bytes);
  void import();

  uint64_t bytes_ = 0, address_ = 0, handle_ = 0;
  BufferStorage storage_;
};

}  // namespace spherepair
