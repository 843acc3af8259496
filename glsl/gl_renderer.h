// SPDX-License-Identifier: MIT
// Draws spheres through the graphics pipeline: the paper's mesh, with a draw a sphere or instanced; GLUT's sphere;
// points; impostors. It reads positions and contacts from the simulation's own buffers.
#pragma once

#include <map>
#include <memory>

#include "common/backend/backend.h"
#include "common/scene/sphere_mesh.h"
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
  std::vector<uint> image();           // of the last draw
  std::vector<float> depths();         // of its pixels: near / z, 0 for the background
  void copy_to(GLuint texture) const;  // the image of the last draw; the texture has its size

  const Preparations& preparations() const { return prepared_; }

  // Draws of all renderers so far. Each binds buffers of its own.
  static uint64_t draws() { return draws_; }

 private:
  struct Mesh {
    GLuint corners = 0;  // buffer
    GLsizei size = 0;    // vertices
  };
  static Mesh make_mesh(const SphereMesh& sphere);
  void make_image(uint width, uint height);
  const Program& program(DrawMethod method);

  std::map<std::string, std::unique_ptr<Program>> programs_;
  Mesh icosphere_, quadric_;
  GLuint vertices_ = 0;  // vertex array
  GLuint frame_ = 0, colour_ = 0, depth_ = 0;
  uint width_ = 0, height_ = 0;
  Preparations prepared_;
  inline static uint64_t draws_ = 0;
};

// Copies pixels, row by row from the top, into a texture of this size.
void texture_from_buffer(GLuint texture, uvec2 size, GLuint buffer);

}  // namespace spherepair
