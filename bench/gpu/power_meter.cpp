// SPDX-License-Identifier: MIT
#include "bench/gpu/power_meter.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

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

struct PowerMeter::Library {
  explicit Library(const std::string& name) : handle(dlopen(name.c_str(), RTLD_NOW)) {
    if (!handle)
      throw BackendError(
          fmt::format("NVML, which tells the energy of an NVIDIA GPU, cannot be loaded ({}): install the "
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
    load(field_values, "nvmlDeviceGetFieldValues");
    check(init(), "starting");
  }
  ~Library() { shutdown(), dlclose(handle); }

  template <typename Function>
  void load(Function*& function, const char* name) {
    function = reinterpret_cast<Function*>(dlsym(handle, name));
    if (!function)
      throw BackendError(fmt::format("this NVML has no {}: it needs a driver that is no older than 2021", name));
  }
  void check(int result, const std::string& what) const {
    if (result != success) throw BackendError(fmt::format("NVML: {} failed: {}", what, error_string(result)));
  }

  void* handle;
  int (*init)() = nullptr;
  int (*shutdown)() = nullptr;
  const char* (*error_string)(int) = nullptr;
  int (*count_devices)(unsigned*) = nullptr;
  int (*device_by_index)(unsigned, void**) = nullptr;
  int (*uuid_of)(void*, char*, unsigned) = nullptr;
  int (*total_energy)(void*, unsigned long long*) = nullptr;
  int (*power_usage)(void*, unsigned*) = nullptr;
  int (*field_values)(void*, int, void*) = nullptr;  // of FieldValues
};

PowerMeter::PowerMeter(const std::string& uuid, const std::string& library)
    : library_(std::make_unique<Library>(library)) {
  unsigned count = 0;
  std::string others;
  library_->check(library_->count_devices(&count), "counting GPUs");
  for (unsigned k = 0; k < count && !device_; ++k) {
    void* device = nullptr;
    char found[96] = {};
    library_->check(library_->device_by_index(k, &device), "opening a GPU");
    library_->check(library_->uuid_of(device, found, sizeof(found)), "reading a UUID");
    if (digits_of(found) == digits_of(uuid)) device_ = device;
    others += (k ? ", " : "") + std::string(found);
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

PowerMeter::~PowerMeter() = default;

uint64_t PowerMeter::millijoules() const {
  unsigned long long energy = 0;
  library_->check(library_->total_energy(device_, &energy), "reading the energy counter, which GPUs since Volta have,");
  return energy;
}

double PowerMeter::watts() const {
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

bool PowerMeter::instant() const { return instant_; }

}  // namespace spherepair
