// SPDX-License-Identifier: MIT
#include "program.h"

#include <fmt/format.h>

#include "backend.h"
#include "embedded_shaders.h"

namespace spherepair {
namespace {

std::string source_of(const std::string& kernel, unsigned block, bool equal_radii, bool atomics_64) {
  const std::string& text = embedded_shaders().at(kernel);
  const size_t after_version = text.find('\n') + 1;
  return text.substr(0, after_version) +
         fmt::format("#define BLOCK {}\n#define EQUAL_RADII {}\n", block, int(equal_radii)) +
         (atomics_64 ? "#extension GL_NV_shader_atomic_int64 : require\n#define ATOMICS_64\n" : "") +
         text.substr(after_version);
}

std::string shader_log(GLuint shader) {
  GLint length = 0;
  glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::string log(std::max(length, 1), '\0');
  glGetShaderInfoLog(shader, length, nullptr, log.data());
  return log;
}

std::string program_log(GLuint program) {
  GLint length = 0;
  glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
  std::string log(std::max(length, 1), '\0');
  glGetProgramInfoLog(program, length, nullptr, log.data());
  return log;
}

}  // namespace

Program::Program(const std::string& kernel, unsigned block, bool equal_radii, bool atomics_64)
    : id_(glCreateProgram()) {
  const std::string source = source_of(kernel, block, equal_radii, atomics_64);
  const char* text = source.c_str();
  const GLuint shader = glCreateShader(GL_COMPUTE_SHADER);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint done = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
  const std::string compile_log = done ? "" : shader_log(shader);
  if (done) {
    glAttachShader(id_, shader);
    glLinkProgram(id_);
    glGetProgramiv(id_, GL_LINK_STATUS, &done);
  }
  glDeleteShader(shader);
  if (done) return;
  const std::string log = compile_log.empty() ? program_log(id_) : compile_log;
  glDeleteProgram(id_);
  throw BackendError(fmt::format("glsl: the driver rejected {}.comp for groups of {}:\n{}", kernel, block, log));
}

}  // namespace spherepair
