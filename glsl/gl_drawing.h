// SPDX-License-Identifier: MIT
// OpenGL draws the spheres of another backend, in a context of its own or a window's.
#pragma once

#include "common/backend/graphics_pipeline.h"
#include "glsl/context.h"
#include "glsl/gl_renderer.h"

namespace spherepair {

// Spheres in the host's memory.
class GlDrawing : public GraphicsPipeline {
 public:
  explicit GlDrawing(const OpenOptions& options);
  ~GlDrawing() override;

  void draw(DrawMethod method, const View& view, const SphereArrays& spheres, std::optional<Transfer> way) override;
  std::vector<uint> image() override;
  std::vector<float> depths() override;
  void finish() override;
  Preparations preparations() const override { return renderer_.preparations() + prepared_; }
  void transfer(const SphereArrays& spheres, std::optional<Transfer> way) override;
  std::optional<Transfer> taken() const override { return taken_; }
  bool show_drawn(uint texture) override;
  bool show_pixels(uint64_t pixels, uvec2 size, uint texture) override;

 protected:
  bool of_window() const { return context_.of_window(); }
  void make_current() const { context_.make_current(); }
  bool try_make_current() const { return context_.try_make_current(); }
  void through_host(const vec4* positions, const uint* counts, uint64_t size);
  // Sets the buffers that the next draw reads.
  void set_source(GLuint positions, GLuint counts, Transfer taken);
  GLuint positions() const { return positions_; }  // the buffers of through_host()
  GLuint counts() const { return counts_; }
  void resize(uint64_t size);  // makes those buffers, unless they have this many spheres
  void count_allocation() { ++prepared_.allocations; }

 private:
  Context context_;
  GlRenderer renderer_;
  GLuint positions_ = 0, counts_ = 0;
  GLuint drawn_positions_ = 0, drawn_counts_ = 0;
  uint64_t size_ = 0;
  std::optional<Transfer> taken_;
  bool busy_ = false;  // an image was drawn and not waited for
  Preparations prepared_;
};

}  // namespace spherepair
