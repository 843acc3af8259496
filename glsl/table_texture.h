// SPDX-License-Identifier: MIT
// The table of cells as a texture of one word a texel: read on another path than storage buffers.
#pragma once

#include <epoxy/gl.h>

#include <cstdint>

namespace spherepair {

class TableTexture {
 public:
  void bind(GLuint buffer, uint64_t texels) {
    if (!id_) glCreateTextures(GL_TEXTURE_BUFFER, 1, &id_);
    glTextureBufferRange(id_, GL_R32UI, buffer, 0, GLsizeiptr(texels * sizeof(uint32_t)));
    glBindTextureUnit(0, id_);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  }
  void forget() { glDeleteTextures(1, &id_); }

 private:
  GLuint id_ = 0;
};

}  // namespace spherepair
