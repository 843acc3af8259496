// SPDX-License-Identifier: MIT
// The kernels that measure what a device can do at best do what they say, at any number of spheres.
#include <algorithm>

#include "bench/measure/floors.h"
#include "tests/support/backends.h"

namespace spherepair {
namespace {

constexpr PeakRate peak_rates[] = {PeakRate::copy, PeakRate::atomics, PeakRate::issue, PeakRate::words};

class PeakRates : public BackendTest {};
INSTANTIATE_BACKENDS(PeakRates);

TEST_P(PeakRates, AreRightAndStayWithinTheirBuffers) {
  PeakRateKernels* const kernels = backend().peak_rates();
  ASSERT_EQ(kernels == nullptr, backend().info().on_host);
  if (!kernels) {
    EXPECT_THROW(peak_rates_of(backend()), BackendError);
    return;
  }
  for (uint64_t n : {1, 127, 4097}) {
    backend().upload(make_scene({.name = "uniform", .n = n}));
    for (PeakRate peak : peak_rates) EXPECT_NO_THROW(kernels->check(peak)) << n << " spheres";
    backend().check_guards();
  }
}

TEST_P(PeakRates, LeaveNothingForTheNextScene) {
  if (backend().info().on_host) GTEST_SKIP() << "the CPU has no peak-rate kernels";
  const Scene scene = make_scene({.name = "random", .n = 1000});
  backend().upload(scene);
  const StepResult before = run_step(backend(), fast_method(backend()));
  for (PeakRate peak : peak_rates) backend().peak_rates()->launch(peak);
  backend().upload(scene);
  const StepResult after = run_step(backend(), fast_method(backend()));
  EXPECT_EQ(before.counts, after.counts);
  EXPECT_TRUE(before.totals.fingerprint == after.totals.fingerprint);
  EXPECT_GT(before.totals.pairs, 0u);
}

// Every kernel of GLSL takes its driver some time; the others' were compiled with the program.
TEST_P(PeakRates, DriversCompileEveryKernel) {
  const std::vector<StageTime> times = backend().compile_kernels();
  if (backend().info().language != "GLSL") {
    EXPECT_TRUE(times.empty());
    return;
  }
  EXPECT_EQ(1, std::ranges::count(times, "collide_triangle", &StageTime::stage));
  EXPECT_TRUE(std::ranges::all_of(times, [](const StageTime& time) { return time.seconds > 0; }));
}

}  // namespace
}  // namespace spherepair
