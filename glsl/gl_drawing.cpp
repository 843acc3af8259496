// SPDX-License-Identifier: MIT
#include "glsl/gl_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace spherepair {
namespace {

GLuint new_buffer(uint64_t bytes) {
  GLuint buffer = 0;
  glCreateBuffers(1, &buffer);
  glNamedBufferStorage(buffer, GLsizeiptr(std::max<uint64_t>(bytes, 16)), nullptr, GL_DYNAMIC_STORAGE_BIT);
  gl_check(fmt::format("making a buffer of {} bytes for spheres to draw", bytes));
  return buffer;
}

}  // namespace

GlDrawing::GlDrawing(const OpenOptions& options) : context_(options) { resize(0); }

GlDrawing::~GlDrawing() {
  if (!try_make_current()) return;  // a lost context has deleted everything
  glDeleteBuffers(1, &positions_);
  glDeleteBuffers(1, &counts_);
}

void GlDrawing::resize(uint64_t size) {
  if (counts_ && size == size_) return;
  glDeleteBuffers(1, &positions_);
  glDeleteBuffers(1, &counts_);
  positions_ = counts_ = 0;
  positions_ = new_buffer(size * sizeof(vec4));
  counts_ = new_buffer(size * sizeof(uint));
  prepared_.allocations += 2;
  size_ = size;
}

void GlDrawing::set_source(GLuint positions, GLuint counts, Transfer taken) {
  drawn_positions_ = positions;
  drawn_counts_ = counts;
  taken_ = taken;
}

void GlDrawing::through_host(const vec4* positions, const uint* counts, uint64_t size) {
  resize(size);
  glNamedBufferSubData(positions_, 0, GLsizeiptr(size * sizeof(vec4)), positions);
  glNamedBufferSubData(counts_, 0, GLsizeiptr(size * sizeof(uint)), counts);
  gl_check("writing spheres to draw");
  set_source(positions_, counts_, Transfer::host);
}

void GlDrawing::transfer(const SphereArrays& spheres, std::optional<Transfer> way) {
  if (way.value_or(Transfer::host) != Transfer::host)
    throw BackendError("only spheres of CUDA and Vulkan can be transferred otherwise than through the host");
  make_current();
  glFinish();  // the last image may still read the buffers that are written next
  through_host(address_of<vec4>(spheres.positions), address_of<uint>(spheres.counts), spheres.size);
}

void GlDrawing::draw(DrawMethod method, const View& view, const SphereArrays& spheres, std::optional<Transfer> way) {
  make_current();
  transfer(spheres, way);
  busy_ = true;
  renderer_.draw(method, view, drawn_positions_, drawn_counts_, uint(spheres.size));
}

std::vector<uint> GlDrawing::image() {
  make_current();
  return renderer_.image();
}

std::vector<float> GlDrawing::depths() {
  make_current();
  return renderer_.depths();
}

bool GlDrawing::show_drawn(uint texture) {
  if (!of_window()) return false;
  make_current();
  renderer_.copy_to(texture);
  return true;
}

bool GlDrawing::show_pixels(uint64_t pixels, uvec2 size, uint texture) {
  if (!of_window()) return false;
  make_current();
  glTextureSubImage2D(texture, 0, 0, 0, GLsizei(size.x), GLsizei(size.y), GL_RGBA, GL_UNSIGNED_BYTE,
                      address_of<uint>(pixels));
  gl_check("uploading an image to the window");
  return true;
}

// Every timed step waits for all contexts: a context without work must cost it nothing.
void GlDrawing::finish() {
  if (!std::exchange(busy_, false)) return;
  make_current();
  glFinish();
  gl_check("drawing spheres that were transferred");
}

}  // namespace spherepair
