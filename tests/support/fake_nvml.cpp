// SPDX-License-Identifier: MIT
// A library in NVML's place: two GPUs, the first idle at 70 W, the second of a power that the test sets. Its counter of
// energy follows the real time and moves every 20 ms.
#include <algorithm>
#include <chrono>
#include <cstring>
#include <mutex>

namespace {

using Clock = std::chrono::steady_clock;

std::mutex access;
unsigned milliwatts = 100'000;
bool tells_instant = true, has_counter = true;
double millijoules = 5e9, scale = 1;  // of the counter against the power
unsigned long long shown = 5'000'000'000ull;
Clock::time_point at = Clock::now(), moved = at;

void advance() {
  const Clock::time_point now = Clock::now();
  millijoules += scale * milliwatts * std::chrono::duration<double>(now - at).count();
  at = now;
  if (now - moved < std::chrono::milliseconds(20)) return;
  moved = now, shown = static_cast<unsigned long long>(millijoules);
}

constexpr int not_supported = 3;
int devices[2];
bool second(const void* device) { return device == &devices[1]; }

struct FieldValue {
  unsigned field, scope;
  long long timestamp, latency;
  int type, result;
  unsigned long long value;
};

}  // namespace

#pragma GCC diagnostic ignored "-Wmissing-declarations"  // NVML's names: no header here has them
extern "C" {

void fake_nvml_power(unsigned to_milliwatts) {
  const std::lock_guard guard(access);
  advance(), milliwatts = to_milliwatts;
}
void fake_nvml_tells(bool instant, bool counter, double counter_scale) {
  const std::lock_guard guard(access);
  advance(), tells_instant = instant, has_counter = counter, scale = counter_scale;
}

int nvmlInit_v2() { return 0; }
int nvmlShutdown() { return 0; }
const char* nvmlErrorString(int error) { return error == not_supported ? "Not Supported" : "Unknown Error"; }
int nvmlDeviceGetCount_v2(unsigned* count) { return *count = 2, 0; }
int nvmlDeviceGetHandleByIndex_v2(unsigned index, void** device) { return *device = &devices[index], 0; }
int nvmlDeviceGetUUID(void* device, char* uuid, unsigned length) {
  const char* names[] = {"GPU-00112233-4455-6677-8899-aabbccddeeff", "GPU-ffeeddcc-bbaa-9988-7766-554433221100"};
  std::strncpy(uuid, names[second(device)], length);
  return 0;
}
int nvmlDeviceGetTotalEnergyConsumption(void* device, unsigned long long* energy) {
  const std::lock_guard guard(access);
  advance();
  return *energy = second(device) ? shown : 7, has_counter ? 0 : not_supported;
}
int nvmlDeviceGetPowerUsage(void* device, unsigned* power) {
  const std::lock_guard guard(access);
  return *power = second(device) ? milliwatts : 70'000, 0;
}
int nvmlDeviceGetMemoryInfo(void* device, unsigned long long* memory) {
  memory[0] = 100'000, memory[2] = second(device) ? 2'000 : 1'000, memory[1] = memory[0] - memory[2];
  return 0;
}
int nvmlDeviceGetFieldValues(void* device, int count, void* field_values) {
  const std::lock_guard guard(access);
  auto* values = static_cast<FieldValue*>(field_values);
  for (int k = 0; k < count; ++k) {
    const bool known = values[k].field == 186 && tells_instant;
    values[k].type = 1, values[k].result = known ? 0 : not_supported;
    values[k].value = second(device) ? milliwatts : 70'000;
  }
  return 0;
}
}
