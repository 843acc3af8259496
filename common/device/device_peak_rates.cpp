// SPDX-License-Identifier: MIT
// What one device can do at best, by kernels that do nothing else; each can be checked.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "common/device/device_backend.h"

namespace spherepair {
namespace {

constexpr Kernel kernels[] = {Kernel::peak_copy, Kernel::peak_atomics, Kernel::peak_issue, Kernel::peak_words};

bool same_bits(const vec4& a, const vec4& b) {
  return float_bits(a.x) == float_bits(b.x) && float_bits(a.y) == float_bits(b.y) &&
         float_bits(a.z) == float_bits(b.z) && float_bits(a.w) == float_bits(b.w);
}

}  // namespace

// The kernels write over velocities and counts: the scene is no longer what was uploaded.
void DeviceBackend::launch_peak_rate(PeakRate ceiling) {
  require_scene("launch_peak_rate");
  launch({kernels[int(ceiling)], SERVICE_BLOCK, {}, per_sphere_groups()}, params_);
  cleared_ = collided_ = false;
}

void DeviceBackend::check_peak_rate(PeakRate ceiling) {
  std::vector<uint> counts(n_, 0);
  if (ceiling == PeakRate::atomics) write(SLOT_COUNT, counts.data(), 0, n_ * sizeof(uint));
  launch_peak_rate(ceiling);
  bool right = false;
  if (ceiling == PeakRate::atomics) {
    read(SLOT_COUNT, counts.data(), 0, n_ * sizeof(uint));
    right = std::accumulate(counts.begin(), counts.end(), uint64_t(0)) == n_;
  } else {
    const State after = state();
    const vec4 ones = {1.0f, 1.0f, 1.0f, 1.0f};
    const std::vector<vec4> expected = ceiling == PeakRate::issue ? std::vector<vec4>(n_, ones) : after.positions;
    right = std::ranges::equal(after.velocities, expected, same_bits);
  }
  if (!right) throw BackendError(fmt::format("{}: {} went wrong", info().name, kernel_name(kernels[int(ceiling)])));
}

}  // namespace spherepair
