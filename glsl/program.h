// SPDX-License-Identifier: MIT
#pragma once

#include <epoxy/gl.h>

#include <memory>
#include <string>
#include <vector>

#include "common/backend/backend.h"
#include "common/device/variant_cache.h"
#include "common/shared/view.h"
#include "glsl/context.h"

namespace spherepair {

// Extensions that shaders use if the driver has them, and how their text comes to the driver.
struct Features {
  bool atomics_64 = false;  // GL_NV_shader_atomic_int64
  bool subgroups = false;   // GL_KHR_shader_subgroup_arithmetic and _shuffle, subgroups of 32 or more
  decltype(OpenOptions::to_spirv) to_spirv = nullptr;
};

// An OpenGL program. For a kernel it compiles the embedded shader of that name, after definitions of the group size,
// the variant and the motion.
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
  void set_view(const View& view) const;  // no effect if the program takes none
  void set_steps(unsigned steps) const;   // sets steps_done; no effect if the program takes none

 private:
  GLuint id_;
  bool takes_view_, takes_steps_;
  mutable View view_{};  // its last value
};

// Compute programs, each compiled on its first use.
class Programs {
 public:
  explicit Programs(const Features& features) : features_(features) {}
  const Program& get(Kernel kernel, unsigned block, const Variant& variant) {
    return cache_.get(kernel, block, variant,
                      [&] { return std::make_unique<Program>(kernel_name(kernel), block, variant, features_); });
  }
  uint64_t compiled() const { return cache_.compiled(); }

 private:
  const Features& features_;
  VariantCache<Program> cache_;
};

// A program of one compute shader; `what` names it where the driver rejects it.
GLuint compute_program(const std::string& source, const std::string& what,
                       decltype(OpenOptions::to_spirv) to_spirv = nullptr);

// The driver's time to compile each kernel, for groups of 128 and the first variant.
std::vector<StageTime> compile_times(Features features);

}  // namespace spherepair
