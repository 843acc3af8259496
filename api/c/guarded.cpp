// SPDX-License-Identifier: MIT
#include "api/c/guarded.h"

#include <fmt/format.h>

#include "api/open.h"
#include "common/device/device.h"
#include "common/scene/host_buffer.h"

namespace spherepair {
namespace {

// Opens the fastest backend, as `spherepair run` does. OpenGL and Vulkan in software are slower than the CPU backend.
std::unique_ptr<Backend> open_fastest(OpenOptions options) {
  options.require_hardware = true;
  for (const std::string& name : gpu_backend_names()) try {
      return open_backend(name, options);
    } catch (const BackendError&) {
    }
  return open_backend("cpu", options);
}

std::unique_ptr<Backend> open(const std::string& name, const char* device, int32_t threads) {
  if (threads < 0) refuse(fmt::format("threads is {}, but must not be negative", threads));
  OpenOptions options;
  options.threads = threads;
  if (device && *device) {
    if (name != "cuda" && name != "vulkan" && !name.starts_with("opengl"))
      refuse(fmt::format("a device is given for the backend {}: name cuda, opengl or vulkan", name));
    (name == "cuda" ? options.cuda_device : name == "vulkan" ? options.vulkan_device : options.gl_device) = device;
  }
  return name == "auto" ? open_fastest(options) : open_backend(name, options);
}

}  // namespace

std::string& open_message() {
  thread_local std::string message;
  return message;
}

sp_status status_of(ListFault fault) {
  return fault == ListFault::argument ? SP_E_ARGUMENT : fault == ListFault::not_finite ? SP_E_NONFINITE : SP_E_RANGE;
}

std::unique_ptr<Backend> open_for_calls(const char* backend, const char* device, int32_t threads) {
  if (!backend) refuse("backend is NULL: name cpu, opengl, cuda, vulkan or auto");
  std::unique_ptr<Backend> opened = open(backend, device, threads);
  opened->leave_thread();
  return opened;
}

void close_for_calls(std::unique_ptr<Backend>& backend) noexcept {
  if (!backend) return;
  try {
    backend->enter_thread();
  } catch (const std::exception&) {  // the device has failed, and an earlier call said so
  }
  backend.reset();  // an OpenGL context leaves the thread as it ends
}

OwnedPairs::OwnedPairs(int64_t pairs, int64_t firsts, uint32_t wanted) : sp_pairs{} {
  make_columns(pairs, firsts, wanted, host_memory, 0, [&](uint64_t bytes) {
    void* const memory = memory_.emplace_back(new std::byte[bytes], std::default_delete<std::byte[]>()).get();
    advise_large_pages(memory, bytes);
    return memory;
  });
}

OwnedPairs::OwnedPairs(int64_t pairs, int64_t firsts, uint32_t wanted, Device& device, int32_t device_id) : sp_pairs{} {
  make_columns(pairs, firsts, wanted, cuda_memory, device_id,
               [&](uint64_t bytes) { return memory_.emplace_back(device.allocate(bytes, {}).owner).get(); });
}

void OwnedPairs::make_columns(int64_t pairs, int64_t firsts, uint32_t wanted, int32_t device_type, int32_t device_id,
                              const Allocate& allocate) {
  size = sizeof(sp_pairs);
  count = pairs;
  const auto make = [&](sp_array& array, sp_type type, size_t bytes, int64_t rows, int64_t columns) {
    // One element more, so that an empty column has an address as well.
    array = {allocate((size_t(rows * columns) + 1) * bytes), rows, columns, columns, 1, type, device_type, device_id};
  };
  make(first, SP_I32, sizeof(int32_t), pairs, 1);
  make(second, SP_I32, sizeof(int32_t), pairs, 1);
  if (wanted & SP_SHIFTS) make(shifts, SP_I32, sizeof(int32_t), pairs, 3);
  if (wanted & SP_VECTORS) make(vectors, SP_F64, sizeof(double), pairs, 3);
  if (wanted & SP_DISTANCES) make(distances, SP_F64, sizeof(double), pairs, 1);
  if (wanted & SP_OFFSETS) make(offsets, SP_I64, sizeof(int64_t), firsts + 1, 1);
}

}  // namespace spherepair
