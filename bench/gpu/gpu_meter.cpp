// SPDX-License-Identifier: MIT
#include "bench/gpu/gpu_meter.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include "common/backend/backend.h"

namespace spherepair {
namespace {

// The used part of NVML's interface, as nvml.h declares it.
constexpr int success = 0;
constexpr unsigned power_instant = 186;  // NVML_FI_DEV_POWER_INSTANT: milliwatts
constexpr int value_is_uint = 1;         // NVML_VALUE_TYPE_UNSIGNED_INT

struct FieldValue {
  unsigned field, scope;
  long long timestamp, latency_us;
  int type, result;
  union {
    double as_double;
    unsigned as_uint;
    unsigned long long as_ulonglong;
  } value;
};
static_assert(sizeof(FieldValue) == 40);

FieldValue power_field() {
  FieldValue value{};
  value.field = power_instant;
  return value;
}

// GPU-01234567-89ab-... as 32 hex digits.
std::string digits_of(const std::string& uuid) {
  std::string digits;
  for (const char c : uuid.substr(uuid.find('-') == std::string::npos ? 0 : uuid.find('-')))
    if (std::isxdigit(static_cast<unsigned char>(c))) digits += char(std::tolower(static_cast<unsigned char>(c)));
  return digits;
}

}  // namespace

struct Nvml {
  explicit Nvml(const std::string& name) : handle(dlopen(name.c_str(), RTLD_NOW)) {
    if (!handle)
      throw BackendError(fmt::format(
          "NVML, which tells the energy and the memory of an NVIDIA GPU, cannot be loaded ({}): install the "
          "GPU's driver, or run on a machine that has one",
          dlerror()));
    load(init, "nvmlInit_v2");
    load(shutdown, "nvmlShutdown");
    load(error_string, "nvmlErrorString");
    load(count_devices, "nvmlDeviceGetCount_v2");
    load(device_by_index, "nvmlDeviceGetHandleByIndex_v2");
    load(uuid_of, "nvmlDeviceGetUUID");
    load(total_energy, "nvmlDeviceGetTotalEnergyConsumption");
    load(power_usage, "nvmlDeviceGetPowerUsage");
    load(memory_info, "nvmlDeviceGetMemoryInfo");
    load(field_values, "nvmlDeviceGetFieldValues");
    check(init(), "starting");
  }
  ~Nvml() { shutdown(), dlclose(handle); }

  template <typename Function>
  void load(Function*& function, const char* name) {
    function = reinterpret_cast<Function*>(dlsym(handle, name));
    if (!function)
      throw BackendError(fmt::format("this NVML has no {}: it needs a driver that is no older than 2021", name));
  }
  void check(int result, const std::string& what) const {
    if (result != success) throw BackendError(fmt::format("NVML: {} failed: {}", what, error_string(result)));
  }

  struct Device {
    void* handle;
    std::string uuid;  // as NVML writes it
  };
  std::vector<Device> devices() const {
    unsigned count = 0;
    check(count_devices(&count), "counting GPUs");
    std::vector<Device> found(count);
    for (unsigned k = 0; k < count; ++k) {
      char uuid[96] = {};
      check(device_by_index(k, &found[k].handle), "opening a GPU");
      check(uuid_of(found[k].handle, uuid, sizeof(uuid)), "reading a UUID");
      found[k].uuid = uuid;
    }
    return found;
  }

  struct Memory {
    unsigned long long total, free, used;  // bytes
  };

  void* handle;
  int (*init)() = nullptr;
  int (*shutdown)() = nullptr;
  const char* (*error_string)(int) = nullptr;
  int (*count_devices)(unsigned*) = nullptr;
  int (*device_by_index)(unsigned, void**) = nullptr;
  int (*uuid_of)(void*, char*, unsigned) = nullptr;
  int (*total_energy)(void*, unsigned long long*) = nullptr;
  int (*power_usage)(void*, unsigned*) = nullptr;
  int (*memory_info)(void*, Memory*) = nullptr;
  int (*field_values)(void*, int, void*) = nullptr;  // of FieldValues
};

GpuMeter::GpuMeter(const std::string& uuid, const std::string& library) : library_(std::make_unique<Nvml>(library)) {
  std::string others;
  for (const Nvml::Device& found : library_->devices()) {
    if (digits_of(found.uuid) == digits_of(uuid)) device_ = found.handle;
    others += (others.empty() ? "" : ", ") + found.uuid;
  }
  if (!device_)
    throw BackendError(
        fmt::format("NVML has no GPU of the UUID {} that the backend runs on: it has {}; choose one of them with "
                    "--cuda-device and --gl-device",
                    uuid, others.empty() ? "none" : others));
  FieldValue value = power_field();
  instant_ = library_->field_values(device_, 1, &value) == success && value.result == success;
  millijoules(), watts();  // throw if the GPU does not offer them
}

GpuMeter::~GpuMeter() = default;

uint64_t GpuMeter::millijoules() const {
  unsigned long long energy = 0;
  library_->check(library_->total_energy(device_, &energy), "reading the energy counter, which GPUs since Volta have,");
  return energy;
}

double GpuMeter::watts() const {
  FieldValue value = power_field();
  if (!instant_) {
    unsigned mean = 0;
    library_->check(library_->power_usage(device_, &mean), "reading the power");
    return 1e-3 * mean;
  }
  library_->check(library_->field_values(device_, 1, &value), "reading the power");
  library_->check(value.result, "reading the power");
  return 1e-3 * (value.type == value_is_uint ? value.value.as_uint : double(value.value.as_ulonglong));
}

bool GpuMeter::instant() const { return instant_; }

std::map<std::string, uint64_t> used_gpu_memory(const std::string& library) {
  const Nvml nvml(library);
  std::map<std::string, uint64_t> used;
  for (const Nvml::Device& device : nvml.devices()) {
    Nvml::Memory memory{};
    nvml.check(nvml.memory_info(device.handle, &memory), "reading the used memory");
    used[digits_of(device.uuid)] = memory.used;
  }
  return used;
}

}  // namespace spherepair
