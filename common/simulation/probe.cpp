// SPDX-License-Identifier: MIT
#include "common/simulation/probe.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "common/scene/scene_params.h"

namespace spherepair {
namespace {

constexpr uint64_t decide_batch = 1u << 20;
constexpr Kernel kernels[] = {Kernel::peak_copy, Kernel::peak_atomics, Kernel::peak_issue, Kernel::peak_words};

bool same_bits(const vec4& a, const vec4& b) {
  return float_bits(a.x) == float_bits(b.x) && float_bits(a.y) == float_bits(b.y) &&
         float_bits(a.z) == float_bits(b.z) && float_bits(a.w) == float_bits(b.w);
}

}  // namespace

void Probe::upload() {
  context_.buffers.resize(SLOT_SPHERES, 16);
  context_.buffers.resize(SLOT_VERDICT, 16);
}

std::vector<uint> Probe::decide(std::span<const vec4> spheres) {
  const uint64_t total = spheres.size() / 2;
  std::vector<uint> verdicts(total);
  context_.buffers.resize(SLOT_SPHERES, std::min(total, decide_batch) * 2 * sizeof(vec4));
  context_.buffers.resize(SLOT_VERDICT, std::min(total, decide_batch) * sizeof(uint));
  Params params{};
  params.search = search_params(Scene{}, true);
  for (uint64_t first = 0; first < total; first += decide_batch) {
    const uint64_t count = std::min(decide_batch, total - first);
    params.n = uint(count);
    context_.buffers.write(SLOT_SPHERES, &spheres[2 * first], 0, count * 2 * sizeof(vec4));
    context_.launch({Kernel::decide, SERVICE_BLOCK, {}, folded(ceil_div(count, SERVICE_BLOCK))}, params);
    context_.buffers.read(SLOT_VERDICT, &verdicts[first], 0, count * sizeof(uint));
  }
  return verdicts;
}

void Probe::launch_empty(uint groups) {
  context_.launch({.kernel = Kernel::empty, .block = SERVICE_BLOCK, .groups = folded(groups), .depends = true});
}

void Probe::enqueue_empty_step(uint launches, const ApiOptions& api) {
  context_.device.begin_step(api);
  for (uint k = 0; k < launches; ++k) launch_empty(1);
  context_.device.end_step();
  ++context_.work().steps;
}

void Probe::launch_peak_rate(PeakRate rate) {
  context_.launch({kernels[int(rate)], SERVICE_BLOCK, {}, groups_per_sphere(context_)});
}

bool Probe::copied_right(PeakRate rate) {
  const vec4 ones = {1.0f, 1.0f, 1.0f, 1.0f};
  const std::vector<vec4> expected = rate == PeakRate::issue ? std::vector<vec4>(context_.n, ones)
                                                             : context_.buffers.read<vec4>(SLOT_POSITION, context_.n);
  return std::ranges::equal(context_.buffers.read<vec4>(SLOT_VELOCITY, context_.n), expected, same_bits);
}

void Probe::check_peak_rate(PeakRate rate) {
  const bool atomics = rate == PeakRate::atomics;
  if (atomics) context_.buffers.write(SLOT_COUNT, std::vector<uint>(context_.n));
  launch_peak_rate(rate);
  bool right = false;
  if (atomics) {
    const std::vector<uint> counts = context_.buffers.read<uint>(SLOT_COUNT, context_.n);
    right = std::accumulate(counts.begin(), counts.end(), uint64_t(0)) == context_.n;
  } else {
    right = copied_right(rate);
  }
  if (!right) throw BackendError(fmt::format("{}: {} went wrong", context_.name(), kernel_name(kernels[int(rate)])));
}

}  // namespace spherepair
