// SPDX-License-Identifier: MIT
// The energy of a step: from a library in NVML's place, whose GPU has a known power, and from samples.
#include <dlfcn.h>

#include <filesystem>
#include <optional>

#include "bench/gpu/energy_study.h"
#include "tests/faults/faulty_session.h"
#include "tests/support/clocked_backend.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

const std::string first_gpu = "00112233445566778899aabbccddeeff", second_gpu = "ffeeddccbbaa99887766554433221100";

// The switches of the library, which stays loaded.
class FakeNvml {
 public:
  FakeNvml() : handle_(dlopen(SPHEREPAIR_FAKE_NVML, RTLD_NOW)) { power(100), tells(true, true); }
  ~FakeNvml() { tells(true, true), dlclose(handle_); }
  void power(unsigned watts) { call<void(unsigned)>("fake_nvml_power", 1000 * watts); }
  void tells(bool instant, bool counter, double scale = 1) {
    call<void(bool, bool, double)>("fake_nvml_tells", instant, counter, scale);
  }

 private:
  template <typename Function, typename... Arguments>
  void call(const char* name, Arguments... arguments) {
    reinterpret_cast<Function*>(dlsym(handle_, name))(arguments...);
  }
  void* handle_;
};

class Energy : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(SPHEREPAIR_FAKE_NVML)) GTEST_SKIP() << "no " << SPHEREPAIR_FAKE_NVML << " here";
    nvml_.emplace();
  }
  FakeNvml& nvml() { return *nvml_; }

 private:
  std::optional<FakeNvml> nvml_;
};

TEST_F(Energy, TheGpuIsThatOfTheUuid) {
  nvml().power(250);
  EXPECT_EQ(GpuMeter(first_gpu, SPHEREPAIR_FAKE_NVML).watts(), 70);
  EXPECT_EQ(GpuMeter(second_gpu, SPHEREPAIR_FAKE_NVML).watts(), 250);
  EXPECT_GE(GpuMeter(second_gpu, SPHEREPAIR_FAKE_NVML).millijoules(), 5'000'000'000u);
  const std::string error = error_of([] { GpuMeter("0123", SPHEREPAIR_FAKE_NVML); });
  for (const char* part : {"0123", "GPU-00112233-4455", "GPU-ffeeddcc", "--cuda-device"})
    EXPECT_NE(error.find(part), std::string::npos) << error;
}

TEST_F(Energy, MemoryIsThatOfEachGpu) {
  const std::map<std::string, uint64_t> used = {{first_gpu, 1'000}, {second_gpu, 2'000}};
  EXPECT_EQ(used_gpu_memory(SPHEREPAIR_FAKE_NVML), used);
}

TEST_F(Energy, PowerThatIsNotInstantIsToldAsSuch) {
  EXPECT_TRUE(GpuMeter(second_gpu, SPHEREPAIR_FAKE_NVML).instant());
  nvml().tells(false, true);
  nvml().power(320);
  const GpuMeter meter(second_gpu, SPHEREPAIR_FAKE_NVML);
  EXPECT_FALSE(meter.instant());
  EXPECT_EQ(meter.watts(), 320);
}

TEST_F(Energy, WhatIsMissingIsNamed) {
  EXPECT_NE(error_of([] { GpuMeter(second_gpu, "libno-such.so.1"); }).find("install the GPU's driver"),
            std::string::npos);
  EXPECT_NE(error_of([] { GpuMeter(second_gpu, SPHEREPAIR_NO_UNNAMED_FILES); }).find("this NVML has no nvmlInit_v2"),
            std::string::npos);
  nvml().tells(true, false);
  EXPECT_NE(error_of([] { GpuMeter(second_gpu, SPHEREPAIR_FAKE_NVML); }).find("energy counter"), std::string::npos);
}

// At 200 W, then 400 W from the 50th of 100 samples on; the counter moves with every tenth sample.
std::vector<PowerSample> samples_from(uint64_t millijoules, uint64_t ends_at) {
  std::vector<PowerSample> samples;
  double energy = 0, shown = 0;
  for (int k = 0; k < 100; ++k) {
    const double watts = k < 50 ? 200 : 400;
    if (k % 10 == 5) shown = energy;
    samples.push_back({0.01 * k, watts, (millijoules + uint64_t(shown + 0.5)) % ends_at});
    energy += 10 * watts;
  }
  return samples;
}

TEST_F(Energy, BothMethodsSpanTheSameTime) {
  const MeanPower power = mean_power(samples_from(1'000'000, ~0ull));
  // From the tick at 0.05 s to that at 0.95 s; the trapezoid between both powers is at 300 W.
  EXPECT_NEAR(power.counter, (45 * 200 + 45 * 400) / 90.0, 1e-6);
  EXPECT_NEAR(power.integrated, (44 * 200 + 300 + 45 * 400) / 90.0, 1e-6);
}

TEST_F(Energy, ACounterThatBeginsAnewGoesOn) {
  const double expected = mean_power(samples_from(0, ~0ull)).counter;
  EXPECT_NEAR(mean_power(samples_from((uint64_t(1) << 32) - 100'000, uint64_t(1) << 32)).counter, expected, 1e-6);
  std::vector<PowerSample> samples = samples_from(0, ~0ull);
  for (PowerSample& sample : samples) sample.millijoules -= 100'000;  // below 2^64 at first
  EXPECT_NEAR(mean_power(samples).counter, expected, 1e-6);
}

TEST_F(Energy, ACounterThatStandsStillIsAnError) {
  std::vector<PowerSample> samples = samples_from(0, ~0ull);
  EXPECT_NE(error_of([&] { mean_power(std::span(samples).first(8)); }).find("once in 8 samples"), std::string::npos);
  EXPECT_NE(error_of([&] { mean_power({}); }).find("not once"), std::string::npos);
}

// 100 W after an upload, 300 W once steps are enqueued; wrong where it is told so.
class PoweredBackend final : public ForwardingBackend {
 public:
  PoweredBackend(const std::string& name, FakeNvml& nvml, bool& wrong)
      : ForwardingBackend(name, open_backend("cpu", {.threads = 1})), nvml_(nvml), wrong_(wrong) {
    info_.software = false;
    info_.uuid = name == "cpu" ? "" : second_gpu;
  }
  void upload(const Scene& scene) override { nvml_.power(100), ForwardingBackend::upload(scene); }
  void enqueue_collide(const CollideOptions& options) override {
    nvml_.power(300), ForwardingBackend::enqueue_collide(options);
  }
  Collisions collisions() override {
    Collisions found = ForwardingBackend::collisions();
    found.pairs += wrong_ && !info_.on_host;
    return found;
  }

 private:
  FakeNvml& nvml_;
  bool& wrong_;
};

struct PoweredSession {
  explicit PoweredSession(FakeNvml& nvml)
      : session({"cpu", "opengl", "cuda"}, {}, [&](const std::string& name, const OpenOptions&) {
          return std::make_unique<PoweredBackend>(name, nvml, wrong);
        }) {}
  bool wrong = false;
  Session session;
};

TEST_F(Energy, IdlePowerIsSubtractedFromThatOfTheSteps) {
  PoweredSession powered(nvml());
  const EnergyOptions options = {.works = {"all_pairs", "cold"}, .sizes = {500}, .seconds = 0.4, .windows = 2};
  int written = 0;
  EnergyStudy study(
      powered.session, options, [&] { ++written; }, SPHEREPAIR_FAKE_NVML);
  study.run();
  EXPECT_EQ(written, 8);
  ASSERT_EQ(study.measurements.size(), 4u) << "two works on two backends";
  for (const json& row : study.measurements) {
    const double step = 1e-3 * row.at("median_ms").get<double>();
    EXPECT_NEAR(row.at("idle_counter_watts"), 100, 8);
    EXPECT_NEAR(row.at("idle_integrated_watts"), 100, 1);
    EXPECT_NEAR(row.at("counter_watts"), 300, 20);
    EXPECT_NEAR(row.at("integrated_watts"), 300, 2);
    EXPECT_NEAR(row.at("joules_per_step").get<double>() / step, 200, 30);
    EXPECT_NEAR(row.at("joules_per_step_integrated").get<double>() / step, 200, 10);
    EXPECT_NEAR(row.at("nanojoules_per_sphere"), 1e9 * row.at("joules_per_step").get<double>() / 500, 1e-3);
    EXPECT_LT(std::abs(row.at("disagreement").get<double>()), 0.15);
    EXPECT_EQ(row.at("windows").size(), 2u);
    EXPECT_EQ(row.at("power"), "instant");
  }
}

TEST_F(Energy, MethodsThatDisagreeAreTold) {
  nvml().tells(true, true, 1.25);
  PoweredSession powered(nvml());
  const EnergyOptions options = {.works = {"all_pairs"}, .sizes = {500}, .seconds = 0.4, .windows = 1};
  EnergyStudy study(
      powered.session, options, [] {}, SPHEREPAIR_FAKE_NVML);
  study.run();
  for (const json& row : study.measurements) EXPECT_NEAR(row.at("disagreement"), -0.2, 0.08);
}

TEST_F(Energy, NoWrongResultIsMeasured) {
  PoweredSession powered(nvml());
  powered.wrong = true;
  const EnergyOptions options = {.works = {"warm"}, .sizes = {500}, .seconds = 0.2, .windows = 1};
  EnergyStudy study(
      powered.session, options, [] {}, SPHEREPAIR_FAKE_NVML);
  EXPECT_NE(difference_of([&] { study.run(); }), "");
  EXPECT_TRUE(study.measurements.empty());
}

class EnergyProgram : public ProgramTest {};

TEST_F(EnergyProgram, NeedsAGpu) {
  const Outcome none = run("energy --backends cpu --results " + path("r"));
  EXPECT_EQ(none.code, 3) << none.output;
  EXPECT_NE(none.errors.find("none of opengl, cuda and vulkan is open"), std::string::npos) << none.errors;
  EXPECT_EQ(run("energy --backends cpu --works hot --results " + path("r")).code, 2);
  if (run("devices --backends opengl --no-gpu").code) GTEST_SKIP() << "no OpenGL in software here";
  const Outcome software = run("energy --backends opengl --no-gpu --results " + path("r"));
  EXPECT_EQ(software.code, 3) << software.output;
  EXPECT_NE(software.errors.find("has no energy counter"), std::string::npos) << software.errors;
}

}  // namespace
}  // namespace spherepair
