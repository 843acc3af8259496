// SPDX-License-Identifier: MIT
#include "glsl/staging.h"

#include <omp.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

#include "glsl/context.h"
#include "glsl/program.h"

namespace spherepair {
namespace {

constexpr uint64_t piece_bytes = 4 << 20;
constexpr uint64_t most_words = 64 << 10;  // most bytes that the kernel reads
constexpr uint64_t alignment = 256;        // of a range of a storage buffer, in bytes: the largest that GL lets a
                                           // driver require
constexpr uint64_t group = 128;
constexpr const char* reader = R"(#version 450
layout(local_size_x = 128) in;
layout(location = 0) uniform uint first;
layout(location = 1) uniform uint words;
layout(std430, binding = 0) restrict readonly buffer From { uint from[]; };
layout(std430, binding = 1) restrict writeonly buffer To { uint to[]; };
void main() {
  uint k = gl_GlobalInvocationID.x;
  if (k < words) to[k] = from[first + k];
}
)";

void wait(GLsync& transferred) {
  if (!transferred) return;
  glClientWaitSync(transferred, GL_SYNC_FLUSH_COMMANDS_BIT, std::numeric_limits<GLuint64>::max());
  glDeleteSync(transferred);
  transferred = nullptr;
}

// Copies with eight threads, which saturate the bus.
void copy(char* to, const char* from, uint64_t bytes) {
  constexpr uint64_t part = 64 << 10;
#pragma omp parallel for num_threads(std::min(8, omp_get_max_threads())) schedule(static)
  for (uint64_t at = 0; at < bytes; at += part) std::memcpy(to + at, from + at, std::min(part, bytes - at));
}

}  // namespace

void Staging::write(GLuint buffer, const void* data, uint64_t offset, uint64_t bytes) {
  if (on_ && bytes > piece_bytes) return write_pieces(buffer, static_cast<const char*>(data), offset, bytes);
  glNamedBufferSubData(buffer, GLintptr(offset), GLsizeiptr(bytes), data);
}

void Staging::read(GLuint buffer, void* data, uint64_t offset, uint64_t bytes) {
  if (on_ && bytes > most_words) return read_pieces(buffer, static_cast<char*>(data), offset, bytes);
  if (on_ && bytes % 4 == 0 && offset % 4 == 0) return read_words(buffer, data, offset, bytes);
  glGetNamedBufferSubData(buffer, GLintptr(offset), GLsizeiptr(bytes), data);
}

void Staging::make() {
  if (pieces_[1].mapped) return;
  forget();
  constexpr GLbitfield mapping = GL_MAP_READ_BIT | GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
  for (Piece& piece : pieces_) {
    glCreateBuffers(1, &piece.buffer);
    glNamedBufferStorage(piece.buffer, piece_bytes, nullptr, mapping | GL_CLIENT_STORAGE_BIT);
    piece.mapped = static_cast<char*>(glMapNamedBufferRange(piece.buffer, 0, piece_bytes, mapping));
    if (!piece.mapped) throw BackendError("opengl: a buffer for transfers could not be mapped; update the driver");
  }
}

void Staging::write_pieces(GLuint buffer, const char* data, uint64_t offset, uint64_t bytes) {
  make();
  for (uint64_t at = 0, turn = 0; at < bytes; at += piece_bytes, ++turn) {
    Piece& piece = pieces_[turn % 2];
    const uint64_t part = std::min(piece_bytes, bytes - at);
    wait(piece.transferred);
    copy(piece.mapped, data + at, part);
    glCopyNamedBufferSubData(piece.buffer, buffer, 0, GLintptr(offset + at), GLsizeiptr(part));
    piece.transferred = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    glFlush();
  }
}

void Staging::read_pieces(GLuint buffer, char* data, uint64_t offset, uint64_t bytes) {
  make();
  const auto request = [&](uint64_t at, Piece& piece) {
    wait(piece.transferred);
    glCopyNamedBufferSubData(buffer, piece.buffer, GLintptr(offset + at), 0,
                             GLsizeiptr(std::min(piece_bytes, bytes - at)));
    piece.transferred = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    glFlush();
  };
  request(0, pieces_[0]);
  for (uint64_t at = 0, turn = 0; at < bytes; at += piece_bytes, ++turn) {
    if (at + piece_bytes < bytes) request(at + piece_bytes, pieces_[(turn + 1) % 2]);
    wait(pieces_[turn % 2].transferred);
    copy(data + at, pieces_[turn % 2].mapped, std::min(piece_bytes, bytes - at));
  }
}

void Staging::read_words(GLuint buffer, void* data, uint64_t offset, uint64_t bytes) {
  make();
  if (!reader_) reader_ = compute_program(reader, "the kernel that reads words");
  Piece& piece = pieces_[0];
  wait(piece.transferred);
  const uint64_t start = offset / alignment * alignment, words = bytes / 4;
  glBindBufferRange(GL_SHADER_STORAGE_BUFFER, 0, buffer, GLintptr(start), GLsizeiptr(offset - start + bytes));
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, piece.buffer);
  glProgramUniform1ui(reader_, 0, GLuint((offset - start) / 4));
  glProgramUniform1ui(reader_, 1, GLuint(words));
  glUseProgram(reader_);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  glDispatchCompute(GLuint((words + group - 1) / group), 1, 1);
  glMemoryBarrier(GL_CLIENT_MAPPED_BUFFER_BARRIER_BIT);
  glFinish();
  std::memcpy(data, piece.mapped, bytes);
}

void Staging::forget() {
  glDeleteProgram(std::exchange(reader_, 0));
  for (Piece& piece : pieces_) {
    if (piece.transferred) glDeleteSync(piece.transferred);
    glDeleteBuffers(1, &piece.buffer);
    piece = {};
  }
}

}  // namespace spherepair
