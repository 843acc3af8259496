// SPDX-License-Identifier: MIT
// OpenGL's own spheres through its graphics pipeline, and images of its kernels in a window's textures.
#pragma once

#include <array>
#include <memory>

#include "common/backend/graphics_pipeline.h"
#include "glsl/context.h"
#include "glsl/gl_renderer.h"
#include "glsl/stage_timer.h"

namespace spherepair {

class GlPipeline final : public GraphicsPipeline {
 public:
  GlPipeline(const Context& context, const std::array<GLuint, SLOT_TOTAL>& buffers, StageTimer& timer)
      : context_(context), buffers_(buffers), timer_(timer) {}

  // Of the buffers; the arrays' addresses are not used.
  void draw(DrawMethod method, const View& view, const SphereArrays& spheres, std::optional<Transfer> way) override;
  void transfer(const SphereArrays&, std::optional<Transfer>) override {}  // they are here
  std::vector<uint> image() override;
  std::vector<float> depths() override;
  void finish() override;
  Preparations preparations() const override { return renderer_ ? renderer_->preparations() : Preparations{}; }
  bool show_drawn(uint texture) override;
  bool show_pixels(const uint* pixels, uvec2 size, uint texture) override;  // of SLOT_IMAGE
  void forget() { renderer_.reset(); }

 private:
  const Context& context_;
  const std::array<GLuint, SLOT_TOTAL>& buffers_;
  StageTimer& timer_;
  std::unique_ptr<GlRenderer> renderer_;
};

}  // namespace spherepair
