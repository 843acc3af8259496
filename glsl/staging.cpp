// SPDX-License-Identifier: MIT
#include "glsl/staging.h"

#include <omp.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "glsl/context.h"

namespace spherepair {
namespace {

constexpr uint64_t piece_bytes = 4 << 20;
constexpr uint64_t least_read = 64 << 10;  // bytes: reading them from a long buffer, NVIDIA's driver moves all of it

void wait(GLsync& transferred) {
  if (!transferred) return;
  glClientWaitSync(transferred, GL_SYNC_FLUSH_COMMANDS_BIT, std::numeric_limits<GLuint64>::max());
  glDeleteSync(transferred);
  transferred = nullptr;
}

// Eight threads reach what the bus takes.
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
  if (on_ && bytes >= least_read) return read_pieces(buffer, static_cast<char*>(data), offset, bytes);
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
    if (!piece.mapped) throw BackendError("glsl: a buffer for transfers could not be mapped; update the driver");
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

void Staging::forget() {
  for (Piece& piece : pieces_) {
    if (piece.transferred) glDeleteSync(piece.transferred);
    glDeleteBuffers(1, &piece.buffer);
    piece = {};
  }
}

}  // namespace spherepair
