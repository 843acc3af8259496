// SPDX-License-Identifier: MIT
#include "glsl/driver_memory.h"

#include <dlfcn.h>
#include <unistd.h>

#include <array>
#include <cstring>

namespace spherepair {
namespace {

// The used part of the CUDA driver API, from its reference: the header comes only with the toolkit.
using DeviceNumber = int;
using Handle = unsigned long long;
using Uuid = std::array<unsigned char, GL_UUID_SIZE_EXT>;
struct Properties {  // CUmemAllocationProp
  int type = 1;      // CU_MEM_ALLOCATION_TYPE_PINNED
  int handles = 1;   // CU_MEM_HANDLE_TYPE_POSIX_FILE_DESCRIPTOR
  int location = 1;  // CU_MEM_LOCATION_TYPE_DEVICE
  DeviceNumber device = 0;
  void* windows = nullptr;
  std::array<unsigned char, 8> flags{};
};
static_assert(sizeof(Properties) == 32);
constexpr int file_descriptor = 1, recommended_granularity = 1, error_out_of_memory = 2;

// Stays open: CUDA's runtime may use it too.
void* cuda_driver() { return dlopen("libcuda.so.1", RTLD_NOW); }

class CudaDriverMemory final : public DriverMemory {
 public:
  // Loads the functions. False if one is missing, or CUDA does not have the GPU.
  bool find() {
    void* library = cuda_driver();
    if (!library) return false;
    const auto load = [&](const char* name, auto& function) {
      function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(library, name));
      return function != nullptr;
    };
    return load("cuInit", initialise_) && load("cuDeviceGetCount", count_) && load("cuDeviceGetUuid_v2", uuid_) &&
           load("cuMemGetAllocationGranularity", granularity_) && load("cuMemCreate", create_) &&
           load("cuMemExportToShareableHandle", export_) && load("cuMemRelease", release_) && initialise_(0) == 0 &&
           find_device() && granularity_(&page_, &properties_, recommended_granularity) == 0;
  }

  std::optional<BufferStorage> allocate(uint64_t bytes) override {
    bytes = (bytes + page_ - 1) / page_ * page_;
    Handle handle = 0;
    const int error = create_(&handle, bytes, &properties_, 0);
    full_ = error == error_out_of_memory;
    if (error != 0) return {};
    int descriptor = -1;
    const bool exported = export_(&descriptor, handle, file_descriptor, 0) == 0;
    release_(handle);  // the memory lives on while an import exists
    if (!exported) return {};
    return import_memory(bytes, descriptor);
  }

  bool full() const override { return full_; }

 private:
  bool find_device() {
    int count = 0;
    Uuid wanted{}, found{};
    glGetUnsignedBytei_vEXT(GL_DEVICE_UUID_EXT, 0, wanted.data());
    if (count_(&count) != 0) return false;
    for (properties_.device = 0; properties_.device < count; ++properties_.device)
      if (uuid_(&found, properties_.device) == 0 && found == wanted) return true;
    return false;
  }

  int (*initialise_)(unsigned) = nullptr;
  int (*count_)(int*) = nullptr;
  int (*uuid_)(Uuid*, DeviceNumber) = nullptr;
  int (*granularity_)(size_t*, const Properties*, int) = nullptr;
  int (*create_)(Handle*, size_t, const Properties*, unsigned long long) = nullptr;
  int (*export_)(void*, Handle, int, unsigned long long) = nullptr;
  int (*release_)(Handle) = nullptr;
  Properties properties_;
  size_t page_ = 0;
  bool full_ = false;
};

}  // namespace

void delete_storage(BufferStorage& storage) {
  glDeleteBuffers(1, &storage.buffer);
  if (storage.memory) glDeleteMemoryObjectsEXT(1, &storage.memory);
  storage = {};
}

std::optional<BufferStorage> import_memory(uint64_t bytes, int descriptor) {
  BufferStorage storage;
  const GLint dedicated = GL_TRUE;
  glCreateMemoryObjectsEXT(1, &storage.memory);
  glMemoryObjectParameterivEXT(storage.memory, GL_DEDICATED_MEMORY_OBJECT_EXT, &dedicated);
  glImportMemoryFdEXT(storage.memory, bytes, GL_HANDLE_TYPE_OPAQUE_FD_EXT, descriptor);
  if (glGetError() != GL_NO_ERROR) {
    close(descriptor);  // a successful import gives it to OpenGL
    delete_storage(storage);
    return {};
  }
  glCreateBuffers(1, &storage.buffer);
  glNamedBufferStorageMemEXT(storage.buffer, GLsizeiptr(bytes), storage.memory, 0);
  if (glGetError() == GL_NO_ERROR) return storage;
  delete_storage(storage);
  return {};
}

bool DriverMemory::present() { return epoxy_has_gl_extension("GL_EXT_memory_object_fd") && cuda_driver(); }

std::unique_ptr<DriverMemory> DriverMemory::open() {
  if (!present()) return nullptr;
  auto memory = std::make_unique<CudaDriverMemory>();
  if (!memory->find()) return nullptr;
  return memory;
}

}  // namespace spherepair
