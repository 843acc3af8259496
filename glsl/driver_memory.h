// SPDX-License-Identifier: MIT
// Device memory that NVIDIA's driver gives through libcuda, imported into OpenGL (GL_EXT_memory_object_fd). It comes in
// pages of 2 MiB at once; GL's own sparse storage has pages of 64 KiB, whose commitment takes a time that grows with
// the square of their number: 5.5 s for 1.6 GB (docs/NOTES/launches.md). Needs no CUDA toolkit and makes no CUDA
// context.
#pragma once

#include <epoxy/gl.h>

#include <cstdint>
#include <memory>
#include <optional>

namespace spherepair {

// A buffer of OpenGL's, and the memory object that it was made from, if it was.
struct BufferStorage {
  GLuint buffer = 0, memory = 0;
};
void delete_storage(BufferStorage& storage);  // in its context

// A buffer of memory that a file descriptor stands for, which is closed or OpenGL's afterwards. Nothing when it fails.
std::optional<BufferStorage> import_memory(uint64_t bytes, int descriptor);

// The memory of the current context's GPU.
class DriverMemory {
 public:
  static bool present();  // whether the driver seems to have such memory

  // None where it has not, or does not know the GPU.
  static std::unique_ptr<DriverMemory> open();
  virtual ~DriverMemory() = default;

  virtual std::optional<BufferStorage> allocate(uint64_t bytes) = 0;  // nothing when it fails ...
  virtual bool full() const = 0;                                      // ... because it does not fit
};

}  // namespace spherepair
