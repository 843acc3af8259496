// SPDX-License-Identifier: MIT
#include "glsl/gl_device.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/backend/checks.h"
#include "common/device/hazards.h"
#include "glsl/buffer_texture.h"
#include "glsl/context.h"
#include "glsl/device_limits.h"
#include "glsl/gl_pipeline.h"
#include "glsl/params_ring.h"
#include "glsl/program.h"
#include "glsl/stage_timer.h"
#include "glsl/staging.h"
#include "glsl/table_windows.h"

namespace spherepair {
namespace {

class GlDevice final : public Device {
 public:
  explicit GlDevice(const OpenOptions& options);
  ~GlDevice() override;
  const BackendInfo& info() const override { return info_; }
  const DeviceCapabilities& capabilities() const override { return capabilities_; }
  void enter_thread() override { context_.make_current(); }
  void leave_thread() noexcept override { context_.leave(); }

  Memory allocate(uint64_t bytes, Memory replaced) override;
  void write(const Memory& memory, const void* data, uint64_t offset, uint64_t bytes) override;
  void read(const Memory& memory, void* data, uint64_t offset, uint64_t bytes) override;
  void clear(const Memory& memory, uint64_t bytes) override;
  void launch(const Launch& launch, const Params& params, const BufferHandles& buffers) override;
  void wait() override;

  void check(const CollideOptions& options) const override;
  void begin_step(const ApiOptions& options) override {
    batched_ = options.batch.value_or(true);
    overlaps_ = options.overlap.value_or(true);
  }
  void end_step() override { batched_ = true; }
  bool reads_texture(Kernel kernel, const Params& params, uint64_t texels, std::optional<bool> wanted) const override;

  void time_stages(bool on) override { stage_times(), timer_.turn(on); }
  std::vector<StageTime> stage_times() override;
  std::vector<StageTime> compile_kernels() override {
    context_.make_current();
    return compile_times(limits_.features);
  }
  GraphicsPipeline* pipeline() override { return &pipeline_; }

 private:
  void forget(BufferStorage& storage);
  void bind(const Launch& launch, const BufferHandles& buffers);
  GLbitfield barriers(const Launch& launch) const;
  TexelRange texels(const Launch& launch, const BufferHandles& buffers) const;
  void dispatch(const Launch& launch, const BufferHandles& buffers);

  Context context_;
  DeviceLimits limits_;
  BackendInfo info_;
  DeviceCapabilities capabilities_;
  BufferMemory memory_{limits_};
  BufferHandles bound_{};  // the buffers that kernels see now
  Staging staging_;
  BufferTextures textures_;
  ParamsRing params_;
  bool batched_ = true;
  bool overlaps_ = true;  // launches without a hazard may overlap, from this step on
  Hazards hazards_;       // forgotten at writes and clears
  Programs programs_{limits_.features};
  StageTimer timer_;
  GlPipeline pipeline_{context_, timer_};
  uint64_t draws_seen_ = 0;  // draws by renderers, which bind buffers of their own
};

GlDevice::GlDevice(const OpenOptions& options) : context_(options) {
  context_.make_current();
  limits_ = device_limits(options);
  info_ = describe_device(context_.software(), limits_);
  staging_.turn(!info_.software);
  capabilities_ = {.largest_buffer = limits_.largest_binding,
                   .atomics_64 = limits_.features.atomics_64,
                   .overlaps_images = true,
                   .bounds_block = 256};  // so that all groups run at once (docs/NOTES/grid.md)
  params_.make();
  gl_check("making the buffer of parameters");
}

GlDevice::~GlDevice() {
  if (!context_.try_make_current()) return;  // a lost context has deleted everything
  pipeline_.forget();
  timer_.forget();
  staging_.forget();
  params_.forget();
  textures_.forget();
}

Memory GlDevice::allocate(uint64_t bytes, Memory replaced) {
  replaced = {};
  context_.make_current();
  const auto owner = std::shared_ptr<BufferStorage>(new BufferStorage(memory_.allocate(bytes)), [this](auto* storage) {
    forget(*storage);
    delete storage;
  });
  ++prepared.allocations;
  return {owner->buffer, bytes, owner};
}

// Forgets the buffer's bindings and textures: a new buffer may get its name.
void GlDevice::forget(BufferStorage& storage) {
  if (!context_.try_make_current()) return;  // a lost context has deleted it
  bound_ = {};
  hazards_.forget();
  textures_.forget();
  delete_storage(storage);
}

void GlDevice::write(const Memory& memory, const void* data, uint64_t offset, uint64_t bytes) {
  if (bytes == 0) return;
  context_.make_current();
  hazards_.forget();
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  staging_.write(GLuint(memory.handle), data, offset, bytes);
  gl_check(fmt::format("writing {} bytes", bytes));
}

void GlDevice::read(const Memory& memory, void* data, uint64_t offset, uint64_t bytes) {
  if (bytes == 0) return;
  context_.make_current();
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  staging_.read(GLuint(memory.handle), data, offset, bytes);
  bound_ = {};
  gl_check(fmt::format("reading {} bytes", bytes));
}

// Binds only the range of slots whose buffers changed: binding costs time, and most launches use the last one's
// buffers.
void GlDevice::bind(const Launch& launch, const BufferHandles& buffers) {
  const BufferHandles wanted = seen_buffers(launch, buffers);
  size_t first = 0, behind = wanted.size();
  while (first < behind && wanted[first] == bound_[first]) ++first;
  while (first < behind && wanted[behind - 1] == bound_[behind - 1]) --behind;
  if (first == behind) return;
  std::array<GLuint, SLOT_TOTAL> names;
  std::copy(&wanted[first], &wanted[first] + (behind - first), names.begin());
  glBindBuffersBase(GL_SHADER_STORAGE_BUFFER, GLuint(first), GLsizei(behind - first), names.data());
  bound_ = wanted;
}

void GlDevice::check(const CollideOptions& options) const {
  refuse_missing(info_.name, options, {.texture_table = true, .library_clear = true, .batch = true, .overlap = true},
                 false);
}

void GlDevice::clear(const Memory& memory, uint64_t bytes) {
  context_.make_current();
  hazards_.forget();
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  timer_.time("gl_clear", [&] {
    glClearNamedBufferSubData(GLuint(memory.handle), GL_R32UI, 0, GLsizeiptr(bytes), GL_RED_INTEGER, GL_UNSIGNED_INT,
                              nullptr);
  });
}

// Whether the kernel reads through a texture. The table of cells may be split into several windows.
bool GlDevice::reads_texture(Kernel kernel, const Params& params, uint64_t texels, std::optional<bool> wanted) const {
  const bool table = kernel == Kernel::collide_grid;
  const bool fits =
      table ? TableWindows(params, limits_.largest_texture).count() > 0 : texels <= limits_.largest_texture;
  if (wanted.value_or(false) && !fits) throw BackendError(texture_too_long(texels, limits_));
  return wanted.value_or(true) && fits;
}

// The barrier bits that make earlier launches' writes visible to this one, for storage blocks and, if it reads one, the
// texture.
GLbitfield GlDevice::barriers(const Launch& launch) const {
  if (!batched_) return GL_ALL_BARRIER_BITS;
  return GL_SHADER_STORAGE_BARRIER_BIT | (launch.variant.texture_table ? GL_TEXTURE_FETCH_BARRIER_BIT : 0);
}

TexelRange GlDevice::texels(const Launch& launch, const BufferHandles& buffers) const {
  if (launch.kernel == Kernel::draw_cull)
    return {PYRAMID_TEXTURE, GL_RG32UI, GLuint(buffers[SLOT_PYRAMID]), 0, launch.texels * sizeof(uvec2)};
  return {CELL_TEXTURE, GL_R32UI, GLuint(buffers[launch.table]), 0, launch.texels * sizeof(uint)};
}

void GlDevice::dispatch(const Launch& launch, const BufferHandles& buffers) {
  if (launch.variant.texture_table) textures_.bind(texels(launch, buffers));
  ++work.launches;
  glDispatchCompute(launch.groups[0], launch.groups[1], launch.groups[2]);
}

// GL keeps an error until it is requested, so dispatches are checked where their results are waited for.
void GlDevice::launch(const Launch& launch, const Params& params, const BufferHandles& buffers) {
  context_.make_current();
  if (std::exchange(draws_seen_, GlRenderer::draws()) != GlRenderer::draws()) bound_ = {}, hazards_.forget();
  Variant variant = launch.variant;
  const bool by_table = launch.kernel == Kernel::collide_grid && variant.texture_table;
  const TableWindows windows(params, limits_.largest_texture);
  variant.windows = by_table && windows.count() > 1;
  variant.folded = launch.groups[1] > 1 || params.first_group != 0;
  const Program& program = programs_.get(launch.kernel, launch.block, variant);
  prepared.compilations = programs_.compiled();
  Params block = params;
  block.motion.steps_done = 0;  // a uniform, since it changes with every step
  params_.bind(block);
  program.set_steps(params.motion.steps_done);
  if (launch.view) program.set_view(*launch.view);
  glUseProgram(program.id());
  bind(launch, buffers);
  const bool overlapped = hazards_.overlaps(launch, buffers, !batched_ || !overlaps_ || variant.texture_table);
  timer_.time(stage_name(launch), [&] {
    overlapped ? void(++work.overlapped) : glMemoryBarrier(barriers(launch));
    if (!variant.windows) return dispatch(launch, buffers);
    windows.dispatch(uint64_t(launch.groups[0]) * launch.groups[1], GLuint(buffers[launch.table]), program.id(),
                     textures_);
    work.launches += windows.count();
  });
  if (!batched_) glFinish(), ++work.waits;
}

void GlDevice::wait() {
  context_.make_current();
  glFinish();
  gl_check("a dispatch, or waiting for it,");
}

std::vector<StageTime> GlDevice::stage_times() {
  wait();
  return timer_.take();
}

}  // namespace

std::unique_ptr<Device> open_gl_device(const OpenOptions& options) { return std::make_unique<GlDevice>(options); }

}  // namespace spherepair
