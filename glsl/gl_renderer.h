// SPDX-License-Identifier: MIT
// Spheres through the graphics pipeline: the paper's mesh, once with a draw a sphere and once instanced; points;
// impostors. It reads positions and contacts from the buffers that it is given: the simulation's own.
#pragma once

#include <map>
#include <memory>

#include "common/backend/backend.h"
#include "glsl/program.h"

namespace spherepair {

class GlRenderer {
 public:
  GlRenderer();  // in the current context
  ~GlRenderer();
  GlRenderer(const GlRenderer&) = delete;
  GlRenderer& operator=(const GlRenderer&) = delete;

  // positions: vec4[n], counts: uint[n].
  void draw(DrawMethod method, const View& view, GLuint positions, GLuint counts, uint n);
  std::vector<uint> image();  // of the last draw

 private:
  void make_mesh();
  void make_image(uint width, uint height);
  const Program& program(DrawMethod method);

  std::map<std::string, std::unique_ptr<Program>> programs_;
  GLuint vertices_ = 0, corners_ = 0;  // vertex array; buffer of the mesh
  GLuint frame_ = 0, colour_ = 0, depth_ = 0;
  uint width_ = 0, height_ = 0;
};

}  // namespace spherepair
