// SPDX-License-Identifier: MIT
// The only folder that knows both APIs. OpenGL has its own context on CUDA's device.
#include <epoxy/gl.h>

#include <cuda_gl_interop.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "common/scene/camera.h"
#include "common/simulation/simulation.h"
#include "cuda/host/check.h"
#include "cuda/host/cuda_device.h"
#include "glsl/context.h"
#include "glsl/gl_renderer.h"
#include "interop/interop.h"
#include "interop/shared_memory.h"

namespace spherepair {
namespace {

// CUDA and OpenGL count devices differently.
void require_same_device() {
  int current = 0;
  cuda_check(cudaGetDevice(&current), "asking for the device");
  std::array<int, 16> devices{};
  unsigned count = 0;
  const cudaError_t error = cudaGLGetDevices(&count, devices.data(), unsigned(devices.size()), cudaGLDeviceListAll);
  cudaGetLastError();
  if (error == cudaSuccess && std::find(devices.begin(), devices.begin() + count, current) != devices.begin() + count)
    return;
  throw BackendError(fmt::format(
      "interop: OpenGL runs on {}, which is not CUDA's device {}; choose one GPU with CUDA_VISIBLE_DEVICES or "
      "--cuda-device, and see that EGL is the GPU driver's own",
      reinterpret_cast<const char*>(glGetString(GL_RENDERER)), current));
}

Simulation& cuda_simulation(Backend& backend) {
  if (auto* simulation = dynamic_cast<Simulation*>(&backend)) return *simulation;
  throw BackendError(
      fmt::format("{} is not the CUDA backend: only CUDA's spheres are transferred to OpenGL", backend.info().name));
}

// Memory of a buffer of the CUDA device.
struct DeviceMemoryView {
  void* data;
  uint64_t bytes;
};
DeviceMemoryView shared(Simulation& cuda, uint slot, uint64_t bytes_per_sphere) {
  cuda.prepare_to_share();
  return {cuda_memory(cuda.device(), slot), cuda.spheres() * bytes_per_sphere};
}

// Host memory that the device reaches directly.
struct PinnedMemory {
  explicit PinnedMemory(uint64_t bytes) { cuda_check(cudaMallocHost(&data, bytes), "allocating pinned memory"); }
  ~PinnedMemory() { cudaFreeHost(data); }
  void* data = nullptr;
};

struct RegisteredBuffer {
  RegisteredBuffer(GLuint buffer) {
    cuda_check(cudaGraphicsGLRegisterBuffer(&resource, buffer, cudaGraphicsRegisterFlagsWriteDiscard),
               "registering a buffer of OpenGL's");
  }
  ~RegisteredBuffer() { cudaGraphicsUnregisterResource(resource); }
  cudaGraphicsResource_t resource = nullptr;
};

// One of the two arrays that are transferred.
struct Channel {
  explicit Channel(DeviceMemoryView source) : source(source) {
    glCreateBuffers(1, &buffer);
    glNamedBufferStorage(buffer, GLsizeiptr(source.bytes), nullptr, GL_DYNAMIC_STORAGE_BIT);
    gl_check("making a buffer to share");
  }
  ~Channel() {
    registered.reset();
    imported.reset();
    if (eglGetCurrentContext() != EGL_NO_CONTEXT) glDeleteBuffers(1, &buffer);  // else it went with a lost context
  }
  Channel(const Channel&) = delete;

  DeviceMemoryView source;
  GLuint buffer = 0;
  std::unique_ptr<PinnedMemory> pinned;
  std::unique_ptr<RegisteredBuffer> registered;
  std::unique_ptr<SharedMemory> imported;
};

class CudaToGl final : public SharedDrawing {
 public:
  CudaToGl(Simulation& cuda, const OpenOptions& options)
      : cuda_(cuda),
        context_(options),
        spheres_(shared(cuda, SLOT_POSITION, sizeof(vec4))),
        contacts_(shared(cuda, SLOT_COUNT, sizeof(uint))) {
    require_same_device();
    renderer_ = std::make_unique<GlRenderer>();
  }
  ~CudaToGl() override {
    if (!context_.try_make_current()) return;
    renderer_.reset();
  }

  void transfer(Transfer way) override {
    context_.make_current();
    cuda_.prepare_to_share();
    way_ = way;
    if (way == Transfer::host) return through_host();
    if (way == Transfer::registered) return through_mapping();
    for (Channel* channel : channels())
      if (!channel->imported) channel->imported = std::make_unique<SharedMemory>(channel->source.bytes);
    glFinish();  // the last image still reads what is written next
    for (Channel* channel : channels()) copy_on_device(channel->imported->address(), *channel);
    cuda_check(cudaStreamSynchronize(nullptr), "waiting for what is transferred");
  }

  void draw(DrawMethod method, const View& view) override {
    context_.make_current();
    check_view(view);
    renderer_->draw(method, view, source_of(spheres_), source_of(contacts_),
                    uint(spheres_.source.bytes / sizeof(vec4)));
  }

  std::vector<uint> image() override {
    context_.make_current();
    return renderer_->image();
  }

  void finish() override {
    context_.make_current();
    glFinish();
    gl_check("drawing what CUDA transferred");
    cuda_.finish();
  }

 private:
  std::array<Channel*, 2> channels() { return {&spheres_, &contacts_}; }
  GLuint source_of(const Channel& channel) const {
    return way_ == Transfer::imported ? channel.imported->buffer() : channel.buffer;
  }
  static void copy_on_device(void* target, const Channel& channel) {
    cuda_check(cudaMemcpyAsync(target, channel.source.data, channel.source.bytes, cudaMemcpyDeviceToDevice, nullptr),
               "copying what is transferred");
  }

  void through_host() {
    for (Channel* channel : channels()) {
      const uint64_t bytes = channel->source.bytes;
      if (!channel->pinned) channel->pinned = std::make_unique<PinnedMemory>(bytes);
      cuda_check(cudaMemcpy(channel->pinned->data, channel->source.data, bytes, cudaMemcpyDeviceToHost),
                 "reading what is transferred");
      glFinish();  // the last image has read what is written next
      glNamedBufferSubData(channel->buffer, 0, GLsizeiptr(bytes), channel->pinned->data);
    }
    gl_check("writing what is transferred");
  }

  void through_mapping() {
    std::array<cudaGraphicsResource_t, 2> resources{};
    for (size_t k = 0; k < 2; ++k) {
      Channel& channel = *channels()[k];
      if (!channel.registered) channel.registered = std::make_unique<RegisteredBuffer>(channel.buffer);
      resources[k] = channel.registered->resource;
    }
    cuda_check(cudaGraphicsMapResources(2, resources.data(), nullptr), "mapping OpenGL's buffers");
    for (size_t k = 0; k < 2; ++k) {
      void* target = nullptr;
      size_t bytes = 0;
      cuda_check(cudaGraphicsResourceGetMappedPointer(&target, &bytes, resources[k]), "asking for a mapped pointer");
      copy_on_device(target, *channels()[k]);
    }
    cuda_check(cudaGraphicsUnmapResources(2, resources.data(), nullptr), "unmapping OpenGL's buffers");
  }

  // The members below need the context until they are gone.
  Simulation& cuda_;
  Context context_;
  Channel spheres_, contacts_;
  std::unique_ptr<GlRenderer> renderer_;
  Transfer way_ = Transfer::host;
};

}  // namespace

std::unique_ptr<SharedDrawing> open_cuda_to_gl(Backend& cuda, const OpenOptions& options) {
  OpenOptions hardware = options;
  hardware.require_hardware = true;
  return std::make_unique<CudaToGl>(cuda_simulation(cuda), hardware);
}

}  // namespace spherepair
