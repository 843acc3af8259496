// SPDX-License-Identifier: MIT
// Draws OpenGL's own spheres through its graphics pipeline, and shows its kernels' images in a window's textures.
#pragma once

#include <memory>

#include "common/backend/graphics_pipeline.h"
#include "glsl/context.h"
#include "glsl/gl_renderer.h"
#include "glsl/stage_timer.h"

namespace spherepair {

class GlPipeline final : public GraphicsPipeline {
 public:
  GlPipeline(const Context& context, StageTimer& timer) : context_(context), timer_(timer) {}

  void draw(DrawMethod method, const View& view, const SphereArrays& spheres, std::optional<Transfer> way) override;
  void transfer(const SphereArrays&, std::optional<Transfer>) override {}  // OpenGL has them already
  std::vector<uint> image() override;
  std::vector<float> depths() override;
  void finish() override;
  Preparations preparations() const override { return renderer_ ? renderer_->preparations() : Preparations{}; }
  bool show_drawn(uint texture) override;
  bool show_pixels(uint64_t pixels, uvec2 size, uint texture) override;
  void forget() { renderer_.reset(); }

 private:
  const Context& context_;
  StageTimer& timer_;
  std::unique_ptr<GlRenderer> renderer_;
};

}  // namespace spherepair
