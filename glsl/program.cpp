// SPDX-License-Identifier: MIT
#include "program.h"

#include <fmt/format.h>

#include "backend.h"
#include "embedded_shaders.h"

namespace spherepair {
namespace {

constexpr const char* real_names[] = {"float", "Two", "double"};  // by Precision

std::string source_of(const std::string& kernel, unsigned block, const Variant& variant) {
  const std::string& text = embedded_shaders().at(kernel);
  const size_t after_version = text.find('\n') + 1;
  const uint method = uint(variant.motion.method), precision = uint(variant.motion.precision);
  return text.substr(0, after_version) +
         fmt::format("#define BLOCK {}\n#define EQUAL_RADII {}\n#define LISTED {}\n", block, int(variant.equal_radii),
                     int(variant.listed)) +
         fmt::format("#define METHOD {}u\n#define PRECISION {}\n#define Real {}\n", method, precision,
                     real_names[precision]) +
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

Program::Program(const std::string& kernel, unsigned block, const Variant& variant) : id_(glCreateProgram()) {
  const std::string source = source_of(kernel, block, variant);
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
