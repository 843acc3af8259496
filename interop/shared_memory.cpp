// SPDX-License-Identifier: MIT
#include "interop/shared_memory.h"

#include <cuda.h>
#include <cuda_runtime.h>
#include <fmt/format.h>

#include "glsl/context.h"

namespace spherepair {
namespace {

// Looks up the driver's functions at run time, so that the program starts without a driver.
template <typename Function>
Function driver_function(const char* name) {
  void* function = nullptr;
  cudaDriverEntryPointQueryResult found;
  if (cudaGetDriverEntryPointByVersion(name, &function, 12000, cudaEnableDefault, &found) != cudaSuccess || !function)
    throw BackendError(fmt::format("interop: the CUDA driver has no {}; update it", name));
  return reinterpret_cast<Function>(function);
}

void check(CUresult result, const char* what) {
  if (result != CUDA_SUCCESS)
    throw BackendError(fmt::format("interop: {} failed with CUDA error {}", what, int(result)));
}

CUmemAllocationProp exported_memory() {
  CUmemAllocationProp properties = {};
  properties.type = CU_MEM_ALLOCATION_TYPE_PINNED;
  properties.requestedHandleTypes = CU_MEM_HANDLE_TYPE_POSIX_FILE_DESCRIPTOR;
  properties.location.type = CU_MEM_LOCATION_TYPE_DEVICE;
  cudaGetDevice(&properties.location.id);
  return properties;
}

}  // namespace

SharedMemory::SharedMemory(uint64_t bytes) : SharedMemory() {
  if (!epoxy_has_gl_extension("GL_EXT_memory_object_fd"))
    throw BackendError("interop: OpenGL here has no GL_EXT_memory_object_fd; update the driver");
  allocate(bytes);
  import();
}

void SharedMemory::allocate(uint64_t bytes) {
  const CUmemAllocationProp properties = exported_memory();
  size_t page = 0;
  check(driver_function<decltype(&cuMemGetAllocationGranularity)>("cuMemGetAllocationGranularity")(
            &page, &properties, CU_MEM_ALLOC_GRANULARITY_RECOMMENDED),
        "asking for the size of a page");
  bytes_ = (bytes + page - 1) / page * page;
  CUmemGenericAllocationHandle handle = 0;
  check(driver_function<decltype(&cuMemCreate)>("cuMemCreate")(&handle, bytes_, &properties, 0), "cuMemCreate");
  handle_ = handle;
  CUdeviceptr address = 0;
  check(driver_function<decltype(&cuMemAddressReserve)>("cuMemAddressReserve")(&address, bytes_, 0, 0, 0),
        "cuMemAddressReserve");
  address_ = address;
  check(driver_function<decltype(&cuMemMap)>("cuMemMap")(address, bytes_, 0, handle, 0), "cuMemMap");
  CUmemAccessDesc access = {};
  access.location = properties.location;
  access.flags = CU_MEM_ACCESS_FLAGS_PROT_READWRITE;
  check(driver_function<decltype(&cuMemSetAccess)>("cuMemSetAccess")(address, bytes_, &access, 1), "cuMemSetAccess");
}

void SharedMemory::import() {
  int descriptor = -1;
  check(driver_function<decltype(&cuMemExportToShareableHandle)>("cuMemExportToShareableHandle")(
            &descriptor, handle_, CU_MEM_HANDLE_TYPE_POSIX_FILE_DESCRIPTOR, 0),
        "exporting memory");
  const auto storage = import_memory(bytes_, descriptor);
  if (!storage) throw BackendError(fmt::format("interop: OpenGL could not import {} bytes of CUDA's memory", bytes_));
  storage_ = *storage;
}

SharedMemory::~SharedMemory() {
  if (context_is_current()) delete_storage(storage_);
  if (address_) {
    driver_function<decltype(&cuMemUnmap)>("cuMemUnmap")(address_, bytes_);
    driver_function<decltype(&cuMemAddressFree)>("cuMemAddressFree")(address_, bytes_);
  }
  if (handle_) driver_function<decltype(&cuMemRelease)>("cuMemRelease")(handle_);
}

}  // namespace spherepair
