// SPDX-License-Identifier: MIT
// A buffer as a texture, whose texels are read on another path than storage buffers.
#pragma once

#include <epoxy/gl.h>

#include <cstdint>

namespace spherepair {

class BufferTexture {
 public:
  void bind(GLenum format, GLuint buffer, uint64_t bytes) {
    if (!id_) glCreateTextures(GL_TEXTURE_BUFFER, 1, &id_);
    glTextureBufferRange(id_, format, buffer, 0, GLsizeiptr(bytes));
    glBindTextureUnit(0, id_);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  }
  void forget() { glDeleteTextures(1, &id_); }

 private:
  GLuint id_ = 0;
};

}  // namespace spherepair
