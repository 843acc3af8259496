// SPDX-License-Identifier: MIT
// A device that counts steps wrongly ends a run with contacts by an error; it does not keep it waiting for ever.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "common/scene/contact_scene.h"
#include "common/shared/contact/skin.h"
#include "common/simulation/simulation.h"

namespace spherepair {
namespace {

// Buffers on the host, and kernels that do nothing; each leapfrog adds to the steps done what `counted` says.
class CountingDevice : public Device {
 public:
  explicit CountingDevice(uint counted) : counted_(counted) {
    info_.name = "opengl", info_.software = true;  // whose crossover is known
    capabilities_.largest_buffer = uint64_t(1) << 31;
    capabilities_.bounds_block = 128;
  }
  const BackendInfo& info() const override { return info_; }
  const DeviceCapabilities& capabilities() const override { return capabilities_; }
  Memory allocate(uint64_t bytes, Memory) override {
    const auto data = std::make_shared<std::vector<char>>(bytes);
    return {handle_of(data->data()), bytes, data};
  }
  void write(const Memory& memory, const void* data, uint64_t offset, uint64_t bytes) override {
    std::copy_n(static_cast<const char*>(data), bytes, data_of(memory) + offset);
  }
  void read(const Memory& memory, void* data, uint64_t offset, uint64_t bytes) override {
    std::copy_n(data_of(memory) + offset, bytes, static_cast<char*>(data));
  }
  void clear(const Memory& memory, uint64_t bytes) override { std::fill_n(data_of(memory), bytes, '\0'); }
  void launch(const Launch& launch, const Params&, const BufferHandles& buffers) override {
    auto* words = reinterpret_cast<uint*>(buffers[SLOT_FAULT]);
    if (launch.kernel == Kernel::contact_grow) words[STEPS_DONE] = 0;
    if (launch.kernel == Kernel::leapfrog) words[STEPS_DONE] += counted_, ++launched;
    if (launched > 1000) throw std::logic_error("steps are launched for ever");
  }
  void wait() override {}
  void check(const CollideOptions&) const override {}
  void begin_step(const ApiOptions&) override {}
  void end_step() override {}
  void time_stages(bool) override {}
  std::vector<StageTime> stage_times() override { return {}; }

  uint64_t launched = 0;  // steps

 private:
  static char* data_of(const Memory& memory) { return reinterpret_cast<char*>(memory.handle); }

  uint counted_;
  BackendInfo info_;
  DeviceCapabilities capabilities_;
};

Scene two_spheres() {
  Scene scene{.name = "two", .positions = {{0, 0, 0, 0.5f}, {3, 0, 0, 0.5f}}, .velocities = {{}, {}}};
  choose_contacts(scene, {.law = ContactLaw::spring});
  return scene;
}

std::string error_of_steps(uint counted, uint64_t steps) {
  auto device = std::make_unique<CountingDevice>(counted);
  CountingDevice& counting = *device;
  Simulation simulation(std::move(device));
  simulation.upload(two_spheres());
  try {
    for (uint64_t step = 0; step < steps; ++step) simulation.move();
    simulation.finish();
  } catch (const BackendError& error) {
    EXPECT_LE(counting.launched, steps);
    return error.what();
  }
  EXPECT_EQ(counting.launched, steps);
  return "";
}

TEST(StuckSteps, OfADeviceThatCountsRightGoOn) { EXPECT_EQ(error_of_steps(1, 20), ""); }

TEST(StuckSteps, CountedTwiceAreAnError) {
  EXPECT_TRUE(error_of_steps(2, 1).starts_with(
      "opengl: of 1 steps with contacts that were launched, the device counts 2 as done: k"));
  EXPECT_NE(error_of_steps(2, 20), "");
}

TEST(StuckSteps, NotCountedAreAnError) {
  EXPECT_NE(error_of_steps(0, 20).find("the device counts 0 as done"), std::string::npos);
}

}  // namespace
}  // namespace spherepair
