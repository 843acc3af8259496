// SPDX-License-Identifier: MIT
// Binds buffers as textures: GPUs read texels by another path than storage buffers.
#pragma once

#include <epoxy/gl.h>

#include <array>
#include <cstdint>
#include <map>

#include "common/shared/layout.h"

namespace spherepair {

// Part of a buffer; offset and size in bytes.
struct TexelRange {
  GLuint unit;  // where shaders find it
  GLenum format;
  GLuint buffer;
  uint64_t offset, bytes;
  auto operator<=>(const TexelRange&) const = default;
};

// Makes and binds buffer textures in the current context. Keeps them, since making one costs as much as a small
// dispatch.
class BufferTextures {
 public:
  void bind(const TexelRange& range) {
    const auto found = made_.find(range);
    const GLuint texture = found != made_.end() ? found->second : make(range);
    GLuint& bound = bound_[range.unit];
    if (texture != bound) glBindTextureUnit(range.unit, texture);
    bound = texture;
  }

  // Deletes all textures. Call this before a buffer is deleted.
  void forget() {
    for (const auto& [range, texture] : made_) glDeleteTextures(1, &texture);
    made_.clear();
    bound_ = {};
  }

 private:
  GLuint make(const TexelRange& range) {
    constexpr size_t most = 64;  // the ranges change with the cells, without limit
    if (made_.size() == most) forget();
    GLuint texture = 0;
    glCreateTextures(GL_TEXTURE_BUFFER, 1, &texture);
    glTextureBufferRange(texture, range.format, range.buffer, GLintptr(range.offset), GLsizeiptr(range.bytes));
    return made_[range] = texture;
  }

  std::map<TexelRange, GLuint> made_;
  std::array<GLuint, TEXTURE_UNITS> bound_{};
};

}  // namespace spherepair
