// SPDX-License-Identifier: MIT
#include "glsl/program.h"

#include <fmt/format.h>

#include <chrono>
#include <cstring>

#include "common/device/kernel_list.h"
#include "common/glsl/embedded_shaders.h"
#include "common/glsl/kernel_text.h"
#include "common/shared/layout.h"

namespace spherepair {
namespace {

std::string source_of(const std::string& kernel, unsigned block, const Variant& variant, Features features) {
  return kernel_text(
      kernel, block, variant,
      {.atomics_64 = features.atomics_64 ? "GL_NV_shader_atomic_int64" : "", .subgroups = features.subgroups});
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

struct Stage {
  GLenum kind;
  std::string source;
  std::vector<uint32_t> spirv = {};  // in place of the source
};

// Compiles and attaches the shader. Returns its log if the driver rejects it.
std::string compile(GLuint program, const Stage& stage) {
  const char* text = stage.source.c_str();
  const GLuint shader = glCreateShader(stage.kind);
  if (stage.spirv.empty()) {
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
  } else {
    glShaderBinary(1, &shader, GL_SHADER_BINARY_FORMAT_SPIR_V_ARB, stage.spirv.data(),
                   GLsizei(stage.spirv.size() * sizeof(uint32_t)));
    glSpecializeShaderARB(shader, "main", 0, nullptr, nullptr);
  }
  GLint done = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
  const std::string log = done ? "" : shader_log(shader);
  if (done) glAttachShader(program, shader);
  glDeleteShader(shader);
  return log;
}

GLuint linked(const std::vector<Stage>& stages, const std::string& what) {
  const GLuint program = glCreateProgram();
  std::string log;
  for (const Stage& stage : stages)
    if (log.empty()) log = compile(program, stage);
  GLint done = 0;
  if (log.empty()) {
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &done);
    if (!done) log = program_log(program);
  }
  if (done) return program;
  glDeleteProgram(program);
  throw BackendError(fmt::format("opengl: the driver rejected {}:\n{}", what, log));
}

// Whether the program has a uniform of this type at this location. Names are optional in SPIR-V, and the driver gives
// samplers the locations that are left.
bool takes(GLuint program, GLint location, GLenum type) {
  constexpr GLenum properties[] = {GL_LOCATION, GL_TYPE};
  GLint uniforms = 0;
  glGetProgramInterfaceiv(program, GL_UNIFORM, GL_ACTIVE_RESOURCES, &uniforms);
  for (GLint k = 0; k < uniforms; ++k) {
    GLint found[2] = {};
    glGetProgramResourceiv(program, GL_UNIFORM, GLuint(k), 2, properties, 2, nullptr, found);
    if (found[0] == location && GLenum(found[1]) == type) return true;
  }
  return false;
}

}  // namespace

GLuint compute_program(const std::string& source, const std::string& what, decltype(OpenOptions::to_spirv) to_spirv) {
  Stage stage{GL_COMPUTE_SHADER, source};
  if (to_spirv) stage.spirv = to_spirv(source, what);
  return linked({stage}, what);
}

Program::Program(const std::string& kernel, unsigned block, const Variant& variant, Features features)
    : id_(compute_program(source_of(kernel, block, variant, features),
                          fmt::format("{}.comp for groups of {}", kernel, block), features.to_spirv)),
      takes_view_(takes(id_, VIEW_LOCATION, GL_UNSIGNED_INT_VEC4)),
      takes_steps_(takes(id_, STEPS_LOCATION, GL_UNSIGNED_INT)) {}

Program::Program(const std::string& stem)
    : id_(linked({{GL_VERTEX_SHADER, embedded_shaders().at(stem + ".vert")},
                  {GL_FRAGMENT_SHADER, embedded_shaders().at(stem + ".frag")}},
                 stem + ".vert with " + stem + ".frag")),
      takes_view_(takes(id_, VIEW_LOCATION, GL_UNSIGNED_INT_VEC4)),
      takes_steps_(false) {}

void Program::set_view(const View& view) const {
  static_assert(sizeof(View) == VIEW_FOURS * sizeof(uvec4));
  if (!takes_view_ || std::memcmp(&view, &view_, sizeof(View)) == 0) return;
  view_ = view;
  glProgramUniform4uiv(id_, VIEW_LOCATION, VIEW_FOURS, reinterpret_cast<const GLuint*>(&view));
}

void Program::set_steps(unsigned steps) const {
  if (takes_steps_) glProgramUniform1ui(id_, STEPS_LOCATION, steps);
}

std::vector<StageTime> compile_times(Features features) {
  using Clock = std::chrono::steady_clock;
  std::vector<StageTime> times;
#define NAME(name, reads, writes) #name,
  for (const std::string kernel : {SPHEREPAIR_MIRRORED_KERNELS(NAME)}) {
    const Clock::time_point start = Clock::now();
    const Program compiled(kernel, SERVICE_BLOCK, {}, features);
    times.push_back({kernel, std::chrono::duration<double>(Clock::now() - start).count()});
  }
#undef NAME
  return times;
}

}  // namespace spherepair
