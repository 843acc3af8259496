// SPDX-License-Identifier: MIT
// Transfers between host arrays and buffers. Large ones go through two small buffers that stay mapped: threads copy one
// of them while the GPU transfers the other; NVIDIA's glGetNamedBufferSubData takes four times as long. A kernel reads
// a few words by copying them to mapped memory: after a dispatch that takes 20 us on an H100, against 107 by
// glGetNamedBufferSubData and 124 by glCopyNamedBufferSubData.
#pragma once

#include <epoxy/gl.h>

#include <array>
#include <cstdint>

namespace spherepair {

class Staging {
 public:
  void turn(bool on) { on_ = on; }  // off, as in software: all transfers use OpenGL's own functions
  void write(GLuint buffer, const void* data, uint64_t offset, uint64_t bytes);
  // Waits for the GPU. May leave other storage buffers bound at 0 and 1, and another program in use.
  void read(GLuint buffer, void* data, uint64_t offset, uint64_t bytes);
  void forget();  // in the context of the transfers

 private:
  struct Piece {
    GLuint buffer = 0;
    char* mapped = nullptr;
    GLsync transferred = nullptr;
  };
  void make();
  void write_pieces(GLuint buffer, const char* data, uint64_t offset, uint64_t bytes);
  void read_pieces(GLuint buffer, char* data, uint64_t offset, uint64_t bytes);
  void read_words(GLuint buffer, void* data, uint64_t offset, uint64_t bytes);

  bool on_ = false;
  std::array<Piece, 2> pieces_;
  GLuint reader_ = 0;  // the program that reads words
};

}  // namespace spherepair
