// SPDX-License-Identifier: MIT
// Which GPU is meant, and what is said where it is not there.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "bench/cli/commands.h"
#include "common/backend/device_name.h"
#include "tests/support/backends.h"
#include "tests/support/program.h"

namespace spherepair {
namespace {

OpenOptions named(const Backend& backend, const std::string& device) {
  OpenOptions options;
  device_option(options, backend.info().name) = device;
  return options;
}

TEST(DeviceNames, AreNumbersOrUuids) {
  EXPECT_TRUE(DeviceName("").empty());
  EXPECT_EQ(DeviceName("12").number, 12u);
  const std::string digits = "80dd8ca93fdcafbcb92a7f7f8132cecf";
  EXPECT_EQ(DeviceName("GPU-80DD8CA9-3fdc-afbc-b92a-7f7f8132cecf").uuid, digits);
  EXPECT_EQ(DeviceName(digits).uuid, digits);
  for (const char* wrong : {"-1", "1.5", "first", "GPU-12", "80dd8ca93fdcafbcb92a7f7f8132cecg"})
    EXPECT_THROW(DeviceName{wrong}, std::invalid_argument) << wrong;
}

TEST(DeviceNames, OneThatIsNotThereIsNamedWithThoseThatAre) {
  for (Backend* backend : open_backends()) {
    if (backend->info().on_host) continue;
    for (const std::string wrong : {"63", "00000000000000000000000000000000"}) {
      try {
        open_backend(backend->info().name, named(*backend, wrong));
        FAIL() << backend->info().name << " opened device " << wrong;
      } catch (const BackendError& error) {
        EXPECT_NE(std::string(error.what()).find(wrong), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("there is no "), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("; the devices are 0 ("), std::string::npos) << error.what();
        EXPECT_TRUE(std::string(error.what()).ends_with(")")) << error.what();
      }
    }
  }
}

TEST(DeviceNames, TheGpuThatIsNamedIsOpened) {
  for (Backend* backend : open_backends()) {
    if (!is_gpu(*backend)) continue;
    const std::string uuid = backend->info().uuid;
    EXPECT_EQ(open_backend(backend->info().name, named(*backend, uuid))->info().uuid, uuid);
  }
}

// On a machine with several GPUs this is not the one that is taken without a name.
TEST(DeviceNames, TheOtherApiTakesTheGpuThatIsNamedForOne) {
  const std::string uuid = last_gpu("cuda");
  if (uuid.empty() || last_gpu("opengl") != uuid) GTEST_SKIP() << "no GPU that both APIs reach";
  OpenOptions for_cuda, for_gl;
  for_cuda.cuda_device = for_gl.gl_device = uuid;
  EXPECT_EQ(open_backend("opengl", for_cuda)->info().uuid, uuid);
  EXPECT_EQ(open_backend("cuda", for_gl)->info().uuid, uuid);
  if (last_gpu("vulkan") == uuid) {
    EXPECT_EQ(open_backend("vulkan", for_cuda)->info().uuid, uuid);
    EXPECT_EQ(open_backend("vulkan", for_gl)->info().uuid, uuid);
  }
  open_backend("cuda", {});  // the other tests' GPU is CUDA's current one again
}

class VisibleDevices : public ProgramTest {
 protected:
  // The GPU of each API where this is all that CUDA sees.
  std::map<std::string, std::string> gpus(const std::string& visible) const {
    const Outcome outcome = run(fmt::format("devices --json {}", path("devices.json")),
                                fmt::format("CUDA_VISIBLE_DEVICES={}; export CUDA_VISIBLE_DEVICES;", visible));
    EXPECT_EQ(outcome.code, kOk) << outcome.errors;
    std::map<std::string, std::string> found;
    const nlohmann::json record = read_json("devices.json");
    for (const nlohmann::json& backend : record.at("backends"))
      if (backend.at("open") && backend.at("uuid") != "") found[backend.at("name")] = backend.at("uuid");
    return found;
  }
};

// As nvidia-smi -L prints it.
std::string with_dashes(const std::string& uuid) {
  const auto part = [&](size_t from, size_t digits) { return uuid.substr(from, digits); };
  return fmt::format("GPU-{}-{}-{}-{}-{}", part(0, 8), part(8, 4), part(12, 4), part(16, 4), part(20, 12));
}

TEST_F(VisibleDevices, OpenGlTakesTheGpuThatIsLeftToCuda) {
  const std::string uuid = last_gpu("cuda");
  if (uuid.empty() || last_gpu("opengl") != uuid) GTEST_SKIP() << "no GPU that both APIs reach";
  open_backend("cuda", {});  // the other tests' GPU is CUDA's current one again
  const std::map<std::string, std::string> found = gpus(with_dashes(uuid));
  EXPECT_GE(found.size(), 2u);
  for (const auto& [backend, taken] : found) EXPECT_EQ(taken, uuid) << backend;
}

TEST_F(VisibleDevices, OpenGlStaysWhereCudaIsLeftNone) {
  const std::map<std::string, std::string> found = gpus("-1");
  EXPECT_EQ(found.count("cuda"), 0u);
  const std::vector<Backend*> there = open_backends();
  EXPECT_EQ(
      found.count("opengl"),
      size_t(std::ranges::count_if(there, [](Backend* one) { return one->info().name == "opengl" && is_gpu(*one); })));
}

}  // namespace
}  // namespace spherepair
