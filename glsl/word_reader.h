// SPDX-License-Identifier: MIT
// Reads a few words of a buffer: a kernel copies them to memory that stays mapped. Behind a dispatch that takes 20 us
// on an NVIDIA H100, glGetNamedBufferSubData 107 and glCopyNamedBufferSubData 124.
#pragma once

#include <epoxy/gl.h>

#include <cstdint>

namespace spherepair {

class WordReader {
 public:
  WordReader();  // in the current context, as all else
  WordReader(const WordReader&) = delete;
  WordReader& operator=(const WordReader&) = delete;
  void forget();

  static constexpr uint64_t most() { return 64 << 10; }  // bytes of a read

  // Offset and bytes are multiples of 4. Waits for the GPU; the storage buffers and the program bound before are not
  // any more.
  void read(GLuint buffer, void* data, uint64_t offset, uint64_t bytes);

 private:
  GLuint program_, target_ = 0;
  const void* mapped_;
};

}  // namespace spherepair
