// SPDX-License-Identifier: MIT
#include "glsl/gl_renderer.h"

#include <fmt/format.h>

#include "glsl/context.h"

namespace spherepair {
namespace {

const char* shaders_of(DrawMethod method) {
  if (method == DrawMethod::points) return "points";
  return method == DrawMethod::impostor ? "impostor" : "mesh";
}

// OpenGL takes the count of vertices of a call as a signed 32-bit number.
uint most_in_one_draw(DrawMethod method) {
  constexpr uint most = 0x7FFFFFFFu;
  return method == DrawMethod::impostor ? most / 6 : most;
}

void set_state(const View& view, GLuint frame) {
  glBindFramebuffer(GL_FRAMEBUFFER, frame);
  glViewport(0, 0, GLsizei(view.width), GLsizei(view.height));
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glEnable(GL_PROGRAM_POINT_SIZE);
  const float background[] = {float(view.background >> 16 & 255) / 255, float(view.background >> 8 & 255) / 255,
                              float(view.background & 255) / 255, 1};
  const float farthest = 0;
  glClearBufferfv(GL_COLOR, 0, background);
  glClearBufferfv(GL_DEPTH, 0, &farthest);
}

}  // namespace

GlRenderer::GlRenderer() {
  icosphere_ = make_mesh(sphere_mesh());
  quadric_ = make_mesh(quadric_mesh());
  glCreateVertexArrays(1, &vertices_);
  glEnableVertexArrayAttrib(vertices_, 0);
  glVertexArrayAttribFormat(vertices_, 0, 3, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayAttribBinding(vertices_, 0, 0);
  glCreateFramebuffers(1, &frame_);
  gl_check("making the renderer");
  prepared_.allocations += 2;
}

GlRenderer::~GlRenderer() {
  if (!context_is_current()) return;  // a lost context has deleted everything
  for (const Mesh& mesh : {icosphere_, quadric_}) glDeleteBuffers(1, &mesh.corners);
  for (GLuint image : {colour_, depth_}) glDeleteRenderbuffers(1, &image);
  glDeleteVertexArrays(1, &vertices_);
  glDeleteFramebuffers(1, &frame_);
}

GlRenderer::Mesh GlRenderer::make_mesh(const SphereMesh& sphere) {
  const std::vector<Corner> corners = sphere.unindexed();
  Mesh mesh{0, GLsizei(corners.size())};
  glCreateBuffers(1, &mesh.corners);
  glNamedBufferStorage(mesh.corners, GLsizeiptr(corners.size() * sizeof(Corner)), corners.data(), 0);
  return mesh;
}

void GlRenderer::make_image(uint width, uint height) {
  if (width == width_ && height == height_) return;
  for (GLuint image : {colour_, depth_}) glDeleteRenderbuffers(1, &image);
  glCreateRenderbuffers(1, &colour_);
  glCreateRenderbuffers(1, &depth_);
  glNamedRenderbufferStorage(colour_, GL_RGBA8, GLsizei(width), GLsizei(height));
  glNamedRenderbufferStorage(depth_, GL_DEPTH_COMPONENT32F, GLsizei(width), GLsizei(height));
  glNamedFramebufferRenderbuffer(frame_, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_);
  glNamedFramebufferRenderbuffer(frame_, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
  gl_check(fmt::format("making an image of {} x {} pixels", width, height));
  if (glCheckNamedFramebufferStatus(frame_, GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw BackendError(fmt::format("opengl: the driver cannot draw into an image of {} x {} pixels", width, height));
  width_ = width;
  height_ = height;
  prepared_.allocations += 2;
}

const Program& GlRenderer::program(DrawMethod method) {
  auto& program = programs_[shaders_of(method)];
  if (!program) program = std::make_unique<Program>(shaders_of(method)), ++prepared_.compilations;
  return *program;
}

void GlRenderer::draw(DrawMethod method, const View& view, GLuint positions, GLuint counts, uint n) {
  ++draws_;
  if (n > most_in_one_draw(method))
    throw BackendError(
        fmt::format("opengl: {} draws at most {} spheres", draw_method_name(method), most_in_one_draw(method)));
  make_image(view.width, view.height);
  set_state(view, frame_);
  glUseProgram(program(method).id());
  program(method).set_view(view);
  glBindVertexArray(vertices_);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SLOT_POSITION, positions);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SLOT_COUNT, counts);
  const Mesh& mesh = method == DrawMethod::quadric ? quadric_ : icosphere_;
  glVertexArrayVertexBuffer(vertices_, 0, mesh.corners, 0, sizeof(Corner));
  if (method == DrawMethod::mesh_each || method == DrawMethod::quadric) {
    for (uint i = 0; i < n; ++i) {
      glUniform1ui(0, i);
      glDrawArrays(GL_TRIANGLES, 0, mesh.size);
    }
  } else if (method == DrawMethod::mesh) {
    glUniform1ui(0, 0);
    glDrawArraysInstanced(GL_TRIANGLES, 0, mesh.size, GLsizei(n));
  } else if (method == DrawMethod::points) {
    glDrawArrays(GL_POINTS, 0, GLsizei(n));
  } else {
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(6 * n));
  }
}

void GlRenderer::copy_to(GLuint texture) const {
  glCopyImageSubData(colour_, GL_RENDERBUFFER, 0, 0, 0, 0, texture, GL_TEXTURE_2D, 0, 0, 0, 0, GLsizei(width_),
                     GLsizei(height_), 1);
  gl_check("copying an image to the window");
}

void texture_from_buffer(GLuint texture, uvec2 size, GLuint buffer) {
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
  glTextureSubImage2D(texture, 0, 0, 0, GLsizei(size.x), GLsizei(size.y), GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  gl_check("copying an image to the window");
}

std::vector<uint> GlRenderer::image() {
  std::vector<uint> pixels(size_t(width_) * height_);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, frame_);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, GLsizei(width_), GLsizei(height_), GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  gl_check("drawing, or reading the image");
  return pixels;
}

std::vector<float> GlRenderer::depths() {
  std::vector<float> pixels(size_t(width_) * height_);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, frame_);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, GLsizei(width_), GLsizei(height_), GL_DEPTH_COMPONENT, GL_FLOAT, pixels.data());
  gl_check("reading the depths of an image");
  return pixels;
}

}  // namespace spherepair
