// SPDX-License-Identifier: MIT
// Buffers as textures, whose texels are read on another path than storage buffers.
#pragma once

#include <epoxy/gl.h>

#include <cstdint>
#include <map>

namespace spherepair {

// Part of a buffer; offset and size in bytes.
struct TexelRange {
  GLenum format;
  GLuint buffer;
  uint64_t offset, bytes;
  auto operator<=>(const TexelRange&) const = default;
};

// The textures that were asked for, in the current context. Each is made once: to make one over costs as much as a
// small dispatch.
class BufferTextures {
 public:
  // To be read at texture unit 0.
  void bind(const TexelRange& range) {
    const auto found = made_.find(range);
    const GLuint texture = found != made_.end() ? found->second : make(range);
    if (texture != bound_) glBindTextureUnit(0, texture);
    bound_ = texture;
  }

  // Deletes all, as must be done before a buffer is deleted.
  void forget() {
    for (const auto& [range, texture] : made_) glDeleteTextures(1, &texture);
    made_.clear();
    bound_ = 0;
  }

 private:
  GLuint make(const TexelRange& range) {
    constexpr size_t most = 64;  // new cells may make new ranges without end
    if (made_.size() == most) forget();
    GLuint texture = 0;
    glCreateTextures(GL_TEXTURE_BUFFER, 1, &texture);
    glTextureBufferRange(texture, range.format, range.buffer, GLintptr(range.offset), GLsizeiptr(range.bytes));
    return made_[range] = texture;
  }

  std::map<TexelRange, GLuint> made_;
  GLuint bound_ = 0;
};

}  // namespace spherepair
