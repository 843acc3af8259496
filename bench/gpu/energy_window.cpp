// SPDX-License-Identifier: MIT
#include "bench/gpu/energy_window.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <thread>
#include <vector>

#include "common/backend/backend.h"

namespace spherepair {
namespace {

constexpr auto sample_every = std::chrono::milliseconds(10);

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

uint64_t difference(uint64_t before, uint64_t after) {
  const bool of_32_bits = after < before && before >> 32 == 0;
  return after - before + (of_32_bits ? uint64_t(1) << 32 : 0);
}

// Takes samples until it is stopped; an error of the meter is thrown then.
class Sampler {
 public:
  explicit Sampler(const GpuMeter& meter) : thread_([this, &meter] { run(meter); }) {}
  ~Sampler() { join(); }

  std::vector<PowerSample> stop() {
    join();
    if (error_) std::rethrow_exception(error_);
    return std::move(samples_);
  }

 private:
  void run(const GpuMeter& meter) {
    try {
      for (; !stopped_; std::this_thread::sleep_for(sample_every)) {
        const double before = now();
        const uint64_t energy = meter.millijoules();
        const double watts = meter.watts();
        samples_.push_back({0.5 * (before + now()), watts, energy});
      }
    } catch (...) {
      error_ = std::current_exception();
    }
  }
  void join() {
    stopped_ = true;
    if (thread_.joinable()) thread_.join();
  }

  std::atomic<bool> stopped_ = false;
  std::vector<PowerSample> samples_;
  std::exception_ptr error_;
  std::thread thread_;  // last: it uses the others
};

}  // namespace

MeanPower mean_power(std::span<const PowerSample> samples) {
  std::vector<size_t> ticks;
  for (size_t k = 1; k < samples.size(); ++k)
    if (samples[k].millijoules != samples[k - 1].millijoules) ticks.push_back(k);
  if (ticks.size() < 2)
    throw BackendError(fmt::format(
        "the GPU's energy counter changed {} in {} samples, but must change twice: take a longer window (--seconds)",
        ticks.empty() ? "not once" : "once", samples.size()));
  const std::span<const PowerSample> between = samples.subspan(ticks.front(), ticks.back() - ticks.front() + 1);
  const double seconds = between.back().seconds - between.front().seconds;
  double counter = 0, integrated = 0;
  for (size_t k = 1; k < between.size(); ++k) {
    const PowerSample &last = between[k - 1], &next = between[k];
    counter += 1e-3 * double(difference(last.millijoules, next.millijoules));
    integrated += 0.5 * (last.watts + next.watts) * (next.seconds - last.seconds);
  }
  return {counter / seconds, integrated / seconds};
}

EnergyWindow measure_window(const GpuMeter& meter, double seconds, double ahead,
                            const std::function<uint64_t()>& work) {
  for (const double start = now(); now() < start + ahead;) work();
  EnergyWindow window;
  Sampler sampler(meter);
  const double start = now();
  while (window.seconds < seconds) {
    window.steps += work();
    window.seconds = now() - start;
  }
  window.power = mean_power(sampler.stop());
  return window;
}

}  // namespace spherepair
