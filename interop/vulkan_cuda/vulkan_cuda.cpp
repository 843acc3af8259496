// SPDX-License-Identifier: MIT
// The only folder that knows Vulkan and CUDA. Each waits for the other through the host.
#include "interop/vulkan_cuda/vulkan_cuda.h"

#include <fmt/format.h>
#include <unistd.h>

#include "cuda/host/check.h"
#include "vulkan/vulkan_device.h"

namespace spherepair {
namespace {

void require_shared(const Device& vulkan, const Device& cuda) {
  const BackendInfo &a = vulkan.info(), &b = cuda.info();
  const char* advice = "; transfer spheres as host";
  if (a.software)
    throw BackendError(
        fmt::format("interop: Vulkan runs in software here ({}), and CUDA cannot map its memory{}", a.device, advice));
  if (a.uuid != b.uuid)
    throw BackendError(
        fmt::format("interop: Vulkan runs on {} ({}) but CUDA on {} ({}), which share no memory; choose one GPU with "
                    "--cuda-device or --vulkan-device alone, or transfer spheres as host",
                    a.device, a.uuid, b.device, b.uuid));
  if (!exports_memory(vulkan))
    throw BackendError(
        fmt::format("interop: Vulkan's driver of {} has no VK_KHR_external_memory_fd; update it{}", a.device, advice));
}

// A buffer of Vulkan's memory that CUDA maps.
class MappedBuffer {
 public:
  MappedBuffer(Device& vulkan, uint64_t bytes) : bytes_(bytes), memory_(export_memory(vulkan, bytes)) {
    try {
      import();
    } catch (const BackendError&) {
      release();
      throw;
    }
  }
  ~MappedBuffer() { release(); }
  MappedBuffer(const MappedBuffer&) = delete;
  MappedBuffer& operator=(const MappedBuffer&) = delete;

  void to_cuda(const Memory& vulkan, const Memory& cuda) {
    memory_->copy(vulkan.handle);
    copy(address_of<void>(cuda.handle), address_);
  }
  void to_vulkan(const Memory& cuda, const Memory& vulkan) {
    copy(address_, address_of<void>(cuda.handle));
    memory_->copy_back(vulkan.handle);
  }

 private:
  void import() {
    cudaExternalMemoryHandleDesc exported{};
    exported.type = cudaExternalMemoryHandleTypeOpaqueFd;
    exported.handle.fd = memory_->descriptor();
    exported.size = memory_->bytes();
    exported.flags = cudaExternalMemoryDedicated;
    const cudaError_t imported = cudaImportExternalMemory(&external_, &exported);  // closes the descriptor
    if (imported != cudaSuccess) close(exported.handle.fd), external_ = nullptr;
    cuda_check(imported, fmt::format("importing {} bytes of Vulkan's memory", bytes_));
    cudaExternalMemoryBufferDesc whole{};
    whole.size = bytes_;
    cuda_check(cudaExternalMemoryGetMappedBuffer(&address_, external_, &whole),
               fmt::format("mapping {} bytes of Vulkan's memory", bytes_));
  }
  void release() {
    cudaFree(address_);
    if (external_) cudaDestroyExternalMemory(external_);
  }
  void copy(const void* to, const void* from) {
    cuda_check(cudaMemcpyAsync(const_cast<void*>(to), from, bytes_, cudaMemcpyDeviceToDevice, nullptr),
               "copying what is transferred");
    cuda_check(cudaStreamSynchronize(nullptr), "waiting for what is transferred");
  }

  uint64_t bytes_;
  std::unique_ptr<ExportedMemory> memory_;
  cudaExternalMemory_t external_ = nullptr;
  void* address_ = nullptr;  // in CUDA
};

}  // namespace

DeviceCopy open_vulkan_cuda(Device& from, Device& to, uint64_t bytes) {
  const bool to_cuda = to.info().name == "cuda";
  Device &vulkan = to_cuda ? from : to, &cuda = to_cuda ? to : from;
  if (vulkan.info().name != "vulkan" || cuda.info().name != "cuda")
    throw BackendError(
        fmt::format("interop: {} and {} share no memory, only Vulkan and CUDA do; transfer spheres as host",
                    from.info().name, to.info().name));
  require_shared(vulkan, cuda);
  const auto shared = std::make_shared<MappedBuffer>(vulkan, bytes);
  if (to_cuda) return [shared](const Memory& source, const Memory& target) { shared->to_cuda(source, target); };
  return [shared](const Memory& source, const Memory& target) { shared->to_vulkan(source, target); };
}

}  // namespace spherepair
