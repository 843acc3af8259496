// SPDX-License-Identifier: MIT
#include "glsl/word_reader.h"

#include <cstring>

#include "common/backend/backend.h"
#include "glsl/program.h"

namespace spherepair {
namespace {

constexpr uint64_t alignment = 256;  // of a range of a storage buffer: the most that GL lets a driver ask for
constexpr uint64_t group = 128;
constexpr const char* source = R"(#version 450
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

}  // namespace

WordReader::WordReader() : program_(compute_program(source, "the kernel that reads words")) {
  constexpr GLbitfield mapping = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
  glCreateBuffers(1, &target_);
  glNamedBufferStorage(target_, most(), nullptr, mapping | GL_CLIENT_STORAGE_BIT);
  mapped_ = glMapNamedBufferRange(target_, 0, most(), mapping);
  if (!mapped_) throw BackendError("glsl: a buffer for reading results could not be mapped; update the driver");
}

void WordReader::forget() {
  glDeleteBuffers(1, &target_);
  glDeleteProgram(program_);
}

void WordReader::read(GLuint buffer, void* data, uint64_t offset, uint64_t bytes) {
  const uint64_t start = offset / alignment * alignment, words = bytes / 4;
  glBindBufferRange(GL_SHADER_STORAGE_BUFFER, 0, buffer, GLintptr(start), GLsizeiptr(offset - start + bytes));
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, target_);
  glProgramUniform1ui(program_, 0, GLuint((offset - start) / 4));
  glProgramUniform1ui(program_, 1, GLuint(words));
  glUseProgram(program_);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  glDispatchCompute(GLuint((words + group - 1) / group), 1, 1);
  glMemoryBarrier(GL_CLIENT_MAPPED_BUFFER_BARRIER_BIT);
  glFinish();
  std::memcpy(data, mapped_, bytes);
}

}  // namespace spherepair
