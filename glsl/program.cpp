// SPDX-License-Identifier: MIT
#include "glsl/program.h"

#include <fmt/format.h>

#include <chrono>
#include <cstring>

#include "common/device/kernel_list.h"
#include "common/shared/layout.h"
#include "glsl/embedded_shaders.h"

namespace spherepair {
namespace {

constexpr const char* real_names[] = {"float", "Two", "double", "int64_t"};  // by Precision

std::string source_of(const std::string& kernel, unsigned block, const Variant& variant, Features features) {
  const std::string& text = embedded_shaders().at(kernel + ".comp");
  const size_t after_version = text.find('\n') + 1;
  const uint method = uint(variant.motion.method), precision = uint(variant.motion.precision);
  return text.substr(0, after_version) +
         fmt::format("#define BLOCK {}\n#define EQUAL_RADII {}\n#define LISTED {}\n#define DENSE {}\n", block,
                     variant.equal_radii, variant.listed, variant.dense) +
         fmt::format("#define FROM_TILES {}\n#define BUNDLES {}\n#define BY_CELLS {}\n", variant.from_tiles,
                     variant.bundles, variant.by_cells) +
         fmt::format("#define INDICES {}u\n", variant.indices) +
         (variant.texture_table ? "#define TEXTURE_TABLE\n" : "") + (variant.windows ? "#define WINDOWS\n" : "") +
         (variant.folded ? "#define FOLDED\n" : "") +
         fmt::format("#define METHOD {}u\n#define PRECISION {}\n#define Real {}\n", method, precision,
                     real_names[precision]) +
         (features.atomics_64 ? "#extension GL_NV_shader_atomic_int64 : require\n#define ATOMICS_64\n" : "") +
         (variant.float_sums ? "#extension GL_NV_shader_atomic_float : require\n#define FLOAT_SUMS\n" : "") +
         (features.subgroups ? "#extension GL_KHR_shader_subgroup_arithmetic : require\n#define SUBGROUPS\n" : "") +
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

struct Stage {
  GLenum kind;
  std::string source;
};

// Attaches the shader; its log when the driver rejects it.
std::string compile(GLuint program, const Stage& stage) {
  const char* text = stage.source.c_str();
  const GLuint shader = glCreateShader(stage.kind);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
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

}  // namespace

GLuint compute_program(const std::string& source, const std::string& what) {
  return linked({{GL_COMPUTE_SHADER, source}}, what);
}

Program::Program(const std::string& kernel, unsigned block, const Variant& variant, Features features)
    : id_(compute_program(source_of(kernel, block, variant, features),
                          fmt::format("{}.comp for groups of {}", kernel, block))) {}

Program::Program(const std::string& stem)
    : id_(linked({{GL_VERTEX_SHADER, embedded_shaders().at(stem + ".vert")},
                  {GL_FRAGMENT_SHADER, embedded_shaders().at(stem + ".frag")}},
                 stem + ".vert with " + stem + ".frag")) {}

const Program& Programs::get(Kernel kernel, unsigned block, const Variant& variant) {
  std::vector<Made>& made = made_[size_t(kernel)];
  for (const Made& known : made)
    if (known.block == block && known.variant == variant) return *known.program;
  made.push_back({block, variant, std::make_unique<Program>(kernel_name(kernel), block, variant, features_)});
  ++compiled_;
  return *made.back().program;
}

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
