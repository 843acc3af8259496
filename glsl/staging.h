// SPDX-License-Identifier: MIT
// Transfers between host arrays and buffers. Large ones go through two small buffers that stay mapped: threads copy one
// of them while the GPU transfers the other. NVIDIA's glGetNamedBufferSubData takes four times as long.
#pragma once

#include <epoxy/gl.h>

#include <array>
#include <cstdint>

namespace spherepair {

class Staging {
 public:
  void turn(bool on) { on_ = on; }  // off, as for software: everything by OpenGL's own functions
  void write(GLuint buffer, const void* data, uint64_t offset, uint64_t bytes);
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

  bool on_ = false;

  std::array<Piece, 2> pieces_;
};

}  // namespace spherepair
