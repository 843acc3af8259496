// SPDX-License-Identifier: MIT
#include "glsl/glsl_backend.h"

#include <fmt/format.h>

#include <cstring>

#include "common/backend/checks.h"
#include "common/device/device_backend.h"
#include "glsl/buffer_texture.h"
#include "glsl/context.h"
#include "glsl/device_limits.h"
#include "glsl/gl_renderer.h"
#include "glsl/program.h"
#include "glsl/stage_timer.h"
#include "glsl/table_windows.h"

namespace spherepair {
namespace {

class GlslBackend final : public DeviceBackend {
 public:
  explicit GlslBackend(const OpenOptions& options);
  ~GlslBackend() override;
  const BackendInfo& info() const override { return info_; }
  void finish() override;
  std::vector<DrawMethod> draw_methods() const override {
    return {all_draw_methods().begin(), all_draw_methods().end()};
  }
  void time_stages(bool on) override { stage_times(), timer_.turn(on); }
  std::vector<StageTime> stage_times() override;
  std::vector<StageTime> compile_kernels() override {
    context_.make_current();
    return compile_times(limits_.features);
  }

 protected:
  void allocate(uint slot, uint64_t bytes) override;
  void write(uint slot, const void* data, uint64_t offset, uint64_t bytes) override;
  void read(uint slot, void* data, uint64_t offset, uint64_t bytes) override;
  void launch(const Launch& launch, const Params& params) override;
  uint64_t largest_binding() const override { return limits_.largest_binding; }
  bool has_atomics_64() const override { return limits_.features.atomics_64; }
  void check_api_options(const CollideOptions& options) const override;
  bool takes_texture(Kernel kernel, const ApiOptions& api) const override;
  bool overlaps_launches() const override { return true; }
  uint bounds_block() const override { return 256; }  // all then run at once (docs/NOTES/NOTES.md)
  void begin_step(const ApiOptions& api) override { batched_ = api.batch.value_or(true); }
  void end_step() override { batched_ = true; }
  void clear_buffer(uint slot, uint64_t bytes) override;
  void draw_by_pipeline(DrawMethod method) override;
  std::vector<uint> pipeline_image() override;

 private:
  void set_params(const Params& params);
  void bind(const Launch& launch);
  GLbitfield barriers(const Launch& launch) const;
  TexelRange texels(const Launch& launch) const;
  void dispatch(const Launch& launch);
  TableWindows windows() const { return {params(), limits_.largest_texture}; }

  Context context_;
  DeviceLimits limits_;
  BackendInfo info_;
  std::array<GLuint, SLOT_TOTAL> buffers_{}, bound_{};  // and which of them kernels see now
  BufferTextures textures_;
  GLuint params_buffer_ = 0;
  Params params_on_device_{};
  bool params_known_ = false, batched_ = true;
  std::optional<Kernel> last_;  // that was launched, with nothing else behind it
  Programs programs_;
  std::unique_ptr<GlRenderer> renderer_;
  StageTimer timer_;
};

GlslBackend::GlslBackend(const OpenOptions& options) : context_(options) {
  context_.make_current();
  limits_ = device_limits(options);
  info_ = describe_device(context_.software(), limits_);
  glCreateBuffers(1, &params_buffer_);
  glNamedBufferStorage(params_buffer_, sizeof(Params), nullptr, GL_DYNAMIC_STORAGE_BIT);
  glBindBufferBase(GL_UNIFORM_BUFFER, SLOT_PARAMS, params_buffer_);  // for good
  gl_check("making the buffer of parameters");
}

GlslBackend::~GlslBackend() {
  if (!context_.try_make_current()) return;  // a lost context took everything with it
  renderer_.reset();
  timer_.forget();
  glDeleteBuffers(GLsizei(buffers_.size()), buffers_.data());
  glDeleteBuffers(1, &params_buffer_);
  textures_.forget();
}

void GlslBackend::allocate(uint slot, uint64_t bytes) {
  context_.make_current();
  bound_ = {};  // a new buffer may get the name of the one deleted
  textures_.forget();
  glDeleteBuffers(1, &buffers_[slot]);
  buffers_[slot] = 0;
  buffers_[slot] = new_buffer(bytes, limits_);
}

void GlslBackend::write(uint slot, const void* data, uint64_t offset, uint64_t bytes) {
  if (bytes == 0) return;
  context_.make_current();
  last_.reset();
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glNamedBufferSubData(buffers_[slot], GLintptr(offset), GLsizeiptr(bytes), data);
  gl_check(fmt::format("writing {} bytes", bytes));
}

void GlslBackend::read(uint slot, void* data, uint64_t offset, uint64_t bytes) {
  if (bytes == 0) return;
  context_.make_current();
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetNamedBufferSubData(buffers_[slot], GLintptr(offset), GLsizeiptr(bytes), data);
  gl_check(fmt::format("reading {} bytes", bytes));
}

// The same parameters serve a whole step, so they are sent only when they change.
void GlslBackend::set_params(const Params& params) {
  if (params_known_ && std::memcmp(&params, &params_on_device_, sizeof(Params)) == 0) return;
  glNamedBufferSubData(params_buffer_, 0, sizeof(Params), &params);
  params_on_device_ = params;
  params_known_ = true;
}

// Binding is dear, and most launches use what the last did.
void GlslBackend::bind(const Launch& launch) {
  std::array<GLuint, SLOT_TOTAL> wanted = buffers_;
  wanted[SLOT_POSITION] = buffers_[position_slot(launch.order)];
  wanted[SLOT_COUNT] = buffers_[count_slot(launch)];
  wanted[SLOT_SPLIT_ID] = buffers_[id_slot(launch.order)];
  wanted[SLOT_SORTED] = buffers_[position_slot(launch.target)];
  wanted[SLOT_ID] = buffers_[id_slot(launch.target)];
  wanted[SLOT_CELL] = buffers_[launch.table];
  wanted[SLOT_VISIBLE] = buffers_[visible_slot()];
  size_t first = 0, behind = wanted.size();
  while (first < behind && wanted[first] == bound_[first]) ++first;
  while (first < behind && wanted[behind - 1] == bound_[behind - 1]) --behind;
  if (first == behind) return;
  glBindBuffersBase(GL_SHADER_STORAGE_BUFFER, GLuint(first), GLsizei(behind - first), &wanted[first]);
  bound_ = wanted;
}

void GlslBackend::check_api_options(const CollideOptions& options) const {
  refuse_missing(
      "glsl", options,
      {.texture_table = true, .texture_spheres = true, .library_clear = true, .batch = true, .overlap = true}, false);
}

void GlslBackend::clear_buffer(uint slot, uint64_t bytes) {
  context_.make_current();
  last_.reset();
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  timer_.time("gl_clear", [&] {
    glClearNamedBufferSubData(buffers_[slot], GL_R32UI, 0, GLsizeiptr(bytes), GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
  });
}

bool GlslBackend::takes_texture(Kernel kernel, const ApiOptions& api) const {
  if (kernel == Kernel::draw_cull) return pyramid_texels() <= limits_.largest_texture;
  const bool table = kernel == Kernel::collide_grid;
  const std::optional<bool> wanted = table ? api.texture_table : api.texture_spheres;
  const bool fits = table ? windows().count() > 0 : spheres() <= limits_.largest_texture;
  if (wanted.value_or(false) && !fits)
    throw BackendError(texture_too_long(table ? windows().words() : spheres(), limits_));
  return wanted.value_or(true) && fits;
}

// What the launches before have written is seen through the paths that this one reads by, after one wait for all.
GLbitfield GlslBackend::barriers(const Launch& launch) const {
  if (!batched_) return GL_ALL_BARRIER_BITS;
  return GL_SHADER_STORAGE_BARRIER_BIT | (launch.variant.texture_table ? GL_TEXTURE_FETCH_BARRIER_BIT : 0);
}

TexelRange GlslBackend::texels(const Launch& launch) const {
  switch (launch.kernel) {
    case Kernel::collide_grid:
      return {CELL_TEXTURE, GL_R32UI, buffers_[launch.table], 0, windows().words() * sizeof(uint)};
    case Kernel::draw_cull:
      return {PYRAMID_TEXTURE, GL_RG32UI, buffers_[SLOT_PYRAMID], 0, pyramid_texels() * sizeof(uvec2)};
    default:
      return {SPHERE_TEXTURE, GL_RGBA32UI, buffers_[position_slot(launch.order)], 0, spheres() * sizeof(vec4)};
  }
}

void GlslBackend::dispatch(const Launch& launch) {
  if (launch.variant.texture_table) textures_.bind(texels(launch));
  ++work_.launches;
  glDispatchCompute(launch.groups[0], launch.groups[1], launch.groups[2]);
}

// GL keeps an error until it is asked, so dispatches are checked where their results are waited for.
void GlslBackend::launch(const Launch& launch, const Params& params) {
  context_.make_current();
  Variant variant = launch.variant;
  variant.windows = launch.kernel == Kernel::collide_grid && variant.texture_table && windows().count() > 1;
  variant.folded = launch.groups[1] > 1 || params.first_group != 0;
  variant.indices = params.in_cells, variant.later = params.totals_later;
  const Program& program = programs_.get(kernel_name(launch.kernel), launch.block, variant, limits_.features);
  set_params(params);
  program.set_view(view());
  glUseProgram(program.id());
  bind(launch);
  const bool overlaps_previous = batched_ && last_ && launch.overlaps_previous == last_;
  timer_.time(stage_name(launch), [&] {
    overlaps_previous ? void(++work_.overlapped) : glMemoryBarrier(barriers(launch));
    if (!variant.windows) return dispatch(launch);
    windows().dispatch(uint64_t(launch.groups[0]) * launch.groups[1], buffers_[launch.table], program.id(), textures_);
    work_.launches += windows().count();
  });
  last_ = launch.kernel;
  if (!batched_) finish(), ++work_.waits;
}

void GlslBackend::draw_by_pipeline(DrawMethod method) {
  context_.make_current();
  last_.reset();
  if (!renderer_) renderer_ = std::make_unique<GlRenderer>();
  bound_ = {};  // the renderer binds its own
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  timer_.time(draw_method_name(method),
              [&] { renderer_->draw(method, view(), buffers_[SLOT_POSITION], buffers_[SLOT_COUNT], spheres()); });
}

std::vector<uint> GlslBackend::pipeline_image() {
  context_.make_current();
  return renderer_->image();
}

void GlslBackend::finish() {
  context_.make_current();
  glFinish();
  gl_check("a dispatch, or waiting for it,");
}

std::vector<StageTime> GlslBackend::stage_times() {
  finish();
  return timer_.take();
}

}  // namespace

std::unique_ptr<Backend> open_glsl_backend(const OpenOptions& options) {
  return std::make_unique<GlslBackend>(options);
}

}  // namespace spherepair
