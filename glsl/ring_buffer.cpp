// SPDX-License-Identifier: MIT
#include "ring_buffer.h"

#include <cstring>

#include "context.h"

namespace spherepair {
namespace {

constexpr uint64_t places = 1024;

}  // namespace

RingBuffer::RingBuffer(GLuint binding, uint64_t bytes) : binding_(binding), bytes_(bytes) {
  GLint alignment = 1;
  glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
  stride_ = (bytes + uint64_t(alignment) - 1) / uint64_t(alignment) * uint64_t(alignment);
  constexpr GLbitfield access = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
  glCreateBuffers(1, &buffer_);
  glNamedBufferStorage(buffer_, GLsizeiptr(places * stride_), nullptr, access);
  mapped_ = static_cast<char*>(glMapNamedBufferRange(buffer_, 0, GLsizeiptr(places * stride_), access));
  gl_check("mapping the buffer of views");
}

// Once around, the first may still be read.
void RingBuffer::write(const void* data) {
  place_ = (place_ + 1) % places;
  if (place_ == 0) glFinish();
  std::memcpy(mapped_ + place_ * stride_, data, bytes_);
  bind();
}

void RingBuffer::bind() const {
  glBindBufferRange(GL_UNIFORM_BUFFER, binding_, buffer_, GLintptr(place_ * stride_), GLsizeiptr(bytes_));
}

void RingBuffer::forget() { glDeleteBuffers(1, &buffer_); }

}  // namespace spherepair
