// SPDX-License-Identifier: MIT
// A uniform block that changes between dispatches: each change goes to another place of one mapped buffer, so that
// nobody waits for those that still read the last.
#pragma once

#include <epoxy/gl.h>

#include <cstdint>

namespace spherepair {

class RingBuffer {
 public:
  RingBuffer(GLuint binding, uint64_t bytes);  // of the block; in the current context
  void write(const void* data);                // and binds it
  void bind() const;
  void forget();  // deletes the buffer

 private:
  GLuint binding_, buffer_ = 0;
  uint64_t bytes_, stride_, place_ = 0;
  char* mapped_ = nullptr;
};

}  // namespace spherepair
