// SPDX-License-Identifier: MIT
#pragma once

#include <epoxy/gl.h>

#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "common/backend/backend.h"
#include "common/device/variant.h"
#include "common/shared/view.h"
#include "glsl/context.h"

namespace spherepair {

// What shaders use where the driver has it.
struct Features {
  bool atomics_64 = false;     // GL_NV_shader_atomic_int64
  bool float_atomics = false;  // GL_NV_shader_atomic_float
  bool subgroups = false;      // GL_KHR_shader_subgroup_arithmetic, with subgroups of 32 invocations or more
};

// A program; one of a compute shader is made from the embedded shader of this name, with the group size, the variant
// and the motion defined in front of it.
class Program {
 public:
  Program(const std::string& kernel, unsigned block, const Variant& variant, Features features);
  explicit Program(const std::string& stem);  // STEM.vert and STEM.frag: a program of the graphics pipeline
  ~Program() {
    if (context_is_current()) glDeleteProgram(id_);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  GLuint id() const { return id_; }
  void set_view(const View& view) const;  // where it takes one

 private:
  GLuint id_;
  bool takes_view_ = glGetUniformLocation(id_, "view_words[0]") >= 0;
  mutable View view_{};  // that it has
};

// Those that were requested, each compiled when it was first.
class Programs {
 public:
  const Program& get(const std::string& kernel, unsigned block, const Variant& variant, Features features) {
    std::unique_ptr<Program>& program = made_[{kernel, block, variant}];
    if (!program) program = std::make_unique<Program>(kernel, block, variant, features);
    return *program;
  }
  uint64_t compiled() const { return made_.size(); }

 private:
  std::map<std::tuple<std::string, unsigned, Variant>, std::unique_ptr<Program>> made_;
};

// What the driver takes for each kernel, for groups of 128 and the first variant.
std::vector<StageTime> compile_times(Features features);

}  // namespace spherepair
