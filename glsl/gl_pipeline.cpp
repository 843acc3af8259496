// SPDX-License-Identifier: MIT
#include "glsl/gl_pipeline.h"

namespace spherepair {

void GlPipeline::draw(DrawMethod method, const View& view, const SphereArrays& spheres, std::optional<Transfer>) {
  context_.make_current();
  if (!renderer_) renderer_ = std::make_unique<GlRenderer>();
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  timer_.time(draw_method_name(method), [&] {
    renderer_->draw(method, view, GLuint(spheres.positions), GLuint(spheres.counts), uint(spheres.size));
  });
}

std::vector<uint> GlPipeline::image() {
  context_.make_current();
  return renderer_->image();
}

std::vector<float> GlPipeline::depths() {
  context_.make_current();
  return renderer_->depths();
}

void GlPipeline::finish() {
  context_.make_current();
  glFinish();
}

bool GlPipeline::show_drawn(uint texture) {
  if (!context_.of_window()) return false;
  context_.make_current();
  renderer_->copy_to(texture);
  return true;
}

bool GlPipeline::show_pixels(uint64_t pixels, uvec2 size, uint texture) {
  if (!context_.of_window()) return false;
  context_.make_current();
  glMemoryBarrier(GL_PIXEL_BUFFER_BARRIER_BIT);
  texture_from_buffer(texture, size, GLuint(pixels));
  return true;
}

}  // namespace spherepair
