// SPDX-License-Identifier: MIT
// Allocates device memory from NVIDIA's driver through libcuda and imports it into OpenGL (GL_EXT_memory_object_fd). It
// has pages of 2 MiB and is ready at once. GL's own sparse storage has pages of 64 KiB, whose commitment takes a time
// that grows with the square of their number: 5.5 s for 1.6 GB (docs/NOTES/launches.md). Needs no CUDA toolkit and
// makes no CUDA context.
#pragma once

#include <epoxy/gl.h>

#include <cstdint>
#include <memory>
#include <optional>

namespace spherepair {

// An OpenGL buffer, and the memory object that it was made from, or 0.
struct BufferStorage {
  GLuint buffer = 0, memory = 0;
};
void delete_storage(BufferStorage& storage);  // call this in its context

// Makes a buffer of the memory behind a file descriptor. Takes the descriptor: closes it or gives it to OpenGL. Nothing
// on failure.
std::optional<BufferStorage> import_memory(uint64_t bytes, int descriptor);

// The memory of the current context's GPU.
class DriverMemory {
 public:
  static bool present();  // whether the driver seems to offer such memory

  // Null if the driver has no such memory or does not know the GPU.
  static std::unique_ptr<DriverMemory> open();
  virtual ~DriverMemory() = default;

  virtual std::optional<BufferStorage> allocate(uint64_t bytes) = 0;  // nothing on failure
  virtual bool full() const = 0;                                      // the last failure was for lack of memory
};

}  // namespace spherepair
