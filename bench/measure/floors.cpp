// SPDX-License-Identifier: MIT
#include "bench/measure/floors.h"

#include <cmath>
#include <limits>

namespace spherepair {

double issue_rate(const Session& session) {
  const Backend* cuda = session.find("cuda");
  if (!cuda) return std::numeric_limits<double>::quiet_NaN();
  const auto& details = cuda->info().details;
  const auto units = details.find("multiprocessors"), clock = details.find("highest clock MHz");
  if (units == details.end() || clock == details.end()) return std::numeric_limits<double>::quiet_NaN();
  return std::stod(units->second) * 128 * std::stod(clock->second) * 1e6;
}

PeakRateKernels& peak_rates_of(Backend& backend) {
  if (PeakRateKernels* kernels = backend.peak_rates()) return *kernels;
  throw BackendError(backend.info().name + ": has no kernels for peak rates; measure a GPU's API");
}

double copy_rate(Session& session, Backend& device, const Sampling& sampling, Progress& progress) {
  constexpr uint64_t beyond_caches = uint64_t(1) << 25;  // spheres: 0.5 GB read, 0.5 GB written
  device.upload(make_scene({.name = "uniform", .n = beyond_caches}));
  peak_rates_of(device).check(PeakRate::copy);
  const Contender copy{.label = device.info().name + " peak copy",
                       .backend = &device,
                       .step = [](Backend& b) { peak_rates_of(b).launch(PeakRate::copy); },
                       .working_set = copy_set_bytes * beyond_caches};
  const std::vector<Samples> samples = measure(session, {&copy, 1}, sampling, progress);
  return 2 * sizeof(vec4) * double(beyond_caches) / samples.front().median_seconds();
}

// Counts position, velocity and count, and the wide state next to the float32 one; for `anchored` anchor, velocity,
// flight, anchor step, next event and count.
uint64_t motion_set_bytes(uint64_t n, MotionOptions motion) {
  const uint64_t wide = motion.precision == Precision::float32 ? 0 : 1;
  if (motion.method == MotionMethod::anchored) return n * (32 + 8 * (1 + wide) + 8 + 4);
  return n * (32 + 4 + wide * 48);
}

uint64_t search_set_bytes(uint64_t n, Method method, bool in_cell_order) {
  if (method == Method::automatic) return 0;
  const uint64_t grid = method == Method::collide_grid ? 7 : 0;
  const uint64_t copies = grid && !in_cell_order ? 2 * (16 + 4) : 0;
  return n * (shared_set_bytes + grid + copies);
}

std::optional<Floor> floor_of(const PeakRates& peak_rates, const Backend& backend, Method method, uint64_t n,
                              bool in_cell_order) {
  if (!on_hardware(backend)) return {};
  const auto copy = peak_rates.copy.find(&backend);
  if (method == Method::collide_grid && copy != peak_rates.copy.end()) {
    const double bytes = double(n) * (in_cell_order ? grid_bytes_in_cell_order : grid_bytes_in_random_order);
    return Floor{"bytes", copy->second, bytes / copy->second};
  }
  const bool all_pairs =
      method == Method::collide_tiled || method == Method::collide_square || method == Method::collide_triangle;
  if (!all_pairs || !(peak_rates.issue > 0)) return {};
  const double pairs = 0.5 * double(n) * double(n - 1);
  return Floor{"instructions", peak_rates.issue, pairs * instructions_per_pair / peak_rates.issue};
}

}  // namespace spherepair
