// SPDX-License-Identifier: MIT
// The only folder that knows CUDA and OpenGL. OpenGL has its own context on CUDA's device.
#include <epoxy/gl.h>

#include <cuda_gl_interop.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "cuda/host/check.h"
#include "glsl/gl_drawing.h"
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
  throw BackendError(
      fmt::format("interop: OpenGL runs on {}, which is not CUDA's device {}; choose one GPU with --cuda-device or "
                  "--gl-device alone, and see that EGL is the GPU driver's own",
                  reinterpret_cast<const char*>(glGetString(GL_RENDERER)), current));
}

void copy_on_device(void* target, const void* source, uint64_t bytes) {
  cuda_check(cudaMemcpyAsync(target, source, bytes, cudaMemcpyDeviceToDevice, nullptr), "copying what is transferred");
}

// Host memory that the device reaches directly.
struct PinnedMemory {
  explicit PinnedMemory(uint64_t bytes) : bytes(bytes) {
    cuda_check(cudaMallocHost(&data, bytes), "allocating pinned memory");
  }
  ~PinnedMemory() { cudaFreeHost(data); }
  uint64_t bytes;
  void* data = nullptr;
};

struct RegisteredBuffer {
  explicit RegisteredBuffer(GLuint buffer) {
    cuda_check(cudaGraphicsGLRegisterBuffer(&resource, buffer, cudaGraphicsRegisterFlagsWriteDiscard),
               "registering a buffer of OpenGL's");
  }
  ~RegisteredBuffer() { cudaGraphicsUnregisterResource(resource); }
  cudaGraphicsResource_t resource = nullptr;
};

// OpenGL's buffers, mapped for CUDA while this object lives.
struct Mapping {
  explicit Mapping(std::array<cudaGraphicsResource_t, 2>& resources) : resources(resources) {
    cuda_check(cudaGraphicsMapResources(2, resources.data(), nullptr), "mapping OpenGL's buffers");
  }
  ~Mapping() { cudaGraphicsUnmapResources(2, resources.data(), nullptr); }
  Mapping(const Mapping&) = delete;
  std::array<cudaGraphicsResource_t, 2>& resources;
};

class CudaToGl final : public GlDrawing {
 public:
  explicit CudaToGl(const OpenOptions& options) : GlDrawing(options) { require_same_device(); }
  ~CudaToGl() override {
    if (try_make_current()) forget(), image_.reset();
  }

  void transfer(const SphereArrays& spheres, std::optional<Transfer> way) override {
    make_current();
    if (spheres.size != size_) forget();
    size_ = spheres.size;
    if (size_ == 0) return through_host(nullptr, nullptr, 0);
    if (way) return transfer_by(*way, spheres);
    while (true) {
      try {
        return transfer_by(fastest_, spheres);
      } catch (const BackendError&) {
        if (fastest_ == Transfer::host) throw;
        fastest_ = fastest_ == Transfer::imported ? Transfer::registered : Transfer::host;
      }
    }
  }

  // Through memory that both APIs share.
  bool show_pixels(uint64_t pixels, uvec2 size, uint texture) override {
    if (!of_window()) return false;
    make_current();
    const uint64_t bytes = uint64_t(size.x) * size.y * sizeof(uint);
    if (image_ && image_->bytes() < bytes) image_.reset();
    make_once(image_, bytes);
    glFinish();  // the last image may still read the buffers that are written next
    copy_on_device(image_->address(), address_of<uint>(pixels), bytes);
    cuda_check(cudaStreamSynchronize(nullptr), "waiting for the image");
    texture_from_buffer(texture, size, image_->buffer());
    return true;
  }

 private:
  struct Array {
    const void* source;
    uint64_t bytes;
  };
  static std::array<Array, 2> arrays(const SphereArrays& spheres) {
    return {Array{address_of<vec4>(spheres.positions), spheres.size * sizeof(vec4)},
            {address_of<uint>(spheres.counts), spheres.size * sizeof(uint)}};
  }

  template <typename Memory, typename Argument>
  void make_once(std::unique_ptr<Memory>& memory, Argument argument) {
    if (memory) return;
    memory = std::make_unique<Memory>(argument);
    count_allocation();
  }

  void forget() {
    for (int k = 0; k < 2; ++k) registered_[k].reset(), imported_[k].reset(), pinned_[k].reset();
  }

  void transfer_by(Transfer way, const SphereArrays& spheres) {
    if (way == Transfer::host) return through_pinned(spheres);
    if (way == Transfer::registered) return through_mapping(spheres);
    for (int k = 0; k < 2; ++k) make_once(imported_[k], arrays(spheres)[k].bytes);
    glFinish();  // the last image may still read the buffers that are written next
    for (int k = 0; k < 2; ++k)
      copy_on_device(imported_[k]->address(), arrays(spheres)[k].source, arrays(spheres)[k].bytes);
    cuda_check(cudaStreamSynchronize(nullptr), "waiting for what is transferred");
    set_source(imported_[0]->buffer(), imported_[1]->buffer(), Transfer::imported);
  }

  void through_pinned(const SphereArrays& spheres) {
    for (int k = 0; k < 2; ++k) {
      const Array array = arrays(spheres)[k];
      make_once(pinned_[k], array.bytes);
      cuda_check(cudaMemcpy(pinned_[k]->data, array.source, array.bytes, cudaMemcpyDeviceToHost),
                 "reading what is transferred");
    }
    glFinish();  // the last image may still read the buffers that are written next
    through_host(static_cast<vec4*>(pinned_[0]->data), static_cast<uint*>(pinned_[1]->data), spheres.size);
  }

  void through_mapping(const SphereArrays& spheres) {
    resize(spheres.size);
    std::array<cudaGraphicsResource_t, 2> resources{};
    for (int k = 0; k < 2; ++k) {
      make_once(registered_[k], k == 0 ? positions() : counts());
      resources[k] = registered_[k]->resource;
    }
    const Mapping mapping(resources);
    for (int k = 0; k < 2; ++k) {
      void* target = nullptr;
      size_t bytes = 0;
      cuda_check(cudaGraphicsResourceGetMappedPointer(&target, &bytes, resources[k]), "asking for a mapped pointer");
      copy_on_device(target, arrays(spheres)[k].source, arrays(spheres)[k].bytes);
    }
    set_source(positions(), counts(), Transfer::registered);
  }

  uint64_t size_ = 0;  // the number of spheres that the memory below holds
  std::array<std::unique_ptr<PinnedMemory>, 2> pinned_;
  std::array<std::unique_ptr<RegisteredBuffer>, 2> registered_;
  std::array<std::unique_ptr<SharedMemory>, 2> imported_;
  std::unique_ptr<SharedMemory> image_;
  Transfer fastest_ = Transfer::imported;  // way that has not failed so far
};

}  // namespace

std::unique_ptr<GraphicsPipeline> open_cuda_to_gl(const OpenOptions& options) {
  OpenOptions hardware = options;
  hardware.require_hardware = true;
  return std::make_unique<CudaToGl>(hardware);
}

}  // namespace spherepair
