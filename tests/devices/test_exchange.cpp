// SPDX-License-Identifier: MIT
// Spheres that one GPU API moves and another searches: through the host between any two, on the GPU between Vulkan and
// CUDA. The sets are those of the CPU, which makes the same steps.
#include "api/exchange.h"

#include <cstring>
#include <filesystem>

#include "tests/support/images.h"

namespace spherepair {
namespace {

Backend* find_backend(const std::string& name) {
  for (Backend* each : open_backends())
    if (each->info().name == name) return each;
  return nullptr;
}

std::vector<Backend*> gpu_apis() {
  std::vector<Backend*> found;
  for (const char* name : {"opengl", "vulkan", "cuda"})
    if (Backend* backend = find_backend(name)) found.push_back(backend);
  return found;
}

void expect_searches_what_the_other_moves(Backend& from, Backend& to, Transfer way) {
  Backend& cpu = *find_backend("cpu");
  for (const MotionMethod motion : {MotionMethod::paper, MotionMethod::anchored}) {
    Scene scene = make_scene({.n = 3000});
    scene.motion.method = motion;
    for (Backend* each : {&from, &to, &cpu}) each->upload(scene);
    Exchange exchange(from, to, way);
    EXPECT_EQ(exchange.bytes(), 3000 * sizeof(vec4));
    CollideOptions options{.method = Method::collide_grid};
    options.want_pairs = true;
    run_step(to, options);  // its cells must not be kept
    for (int step = 0; step < 3; ++step) {
      for (Backend* each : {&from, &cpu}) each->move();
      exchange.run();
      const StepResult found = run_step(to, options), expected = run_step(cpu, options);
      EXPECT_TRUE(same_result(found, expected))
          << from.info().name << " to " << to.info().name << ", " << transfer_name(way) << ", step " << step;
      EXPECT_EQ(hash_of_state(from), hash_of_state(cpu)) << "the spheres of " << from.info().name << " have changed";
    }
    for (Backend* each : {&from, &to}) each->check_guards();
  }
}

std::string complaint(Backend& from, Backend& to, Transfer way) {
  try {
    Exchange(from, to, way).run();
  } catch (const BackendError& error) {
    return error.what();
  }
  return "";
}

TEST(Exchange, ThroughTheHostBetweenAnyTwoApis) {
  const std::vector<Backend*> all = gpu_apis();
  if (all.size() < 2) GTEST_SKIP() << "fewer than two GPU APIs";
  for (Backend* from : all)
    for (Backend* to : all)
      if (from != to) expect_searches_what_the_other_moves(*from, *to, Transfer::host);
}

bool has_positions(Backend& backend, const Scene& scene) {
  const std::vector<vec4> found = backend.state().positions;
  return found.size() == scene.size() &&
         std::memcmp(found.data(), scene.positions.data(), found.size() * sizeof(vec4)) == 0;
}

class ExchangeOnTheGpu : public testing::Test {
 protected:
  void SetUp() override {
    vulkan_ = find_backend("vulkan"), cuda_ = find_backend("cuda");
    if (!vulkan_ || !cuda_) GTEST_SKIP() << "needs Vulkan and CUDA";
    if (vulkan_->info().uuid != cuda_->info().uuid) GTEST_SKIP() << "Vulkan and CUDA are not on one GPU";
  }
  Backend *vulkan_ = nullptr, *cuda_ = nullptr;
};

TEST_F(ExchangeOnTheGpu, VulkanMovesAndCudaSearches) {
  expect_searches_what_the_other_moves(*vulkan_, *cuda_, Transfer::imported);
}

TEST_F(ExchangeOnTheGpu, CudaMovesAndVulkanSearches) {
  expect_searches_what_the_other_moves(*cuda_, *vulkan_, Transfer::imported);
}

uint64_t open_descriptors() {
  return uint64_t(std::distance(std::filesystem::directory_iterator("/proc/self/fd"), {}));
}

// Sizes below and above a large page. Each exchange exports memory anew, and must close its descriptor.
TEST_F(ExchangeOnTheGpu, ThereAndBackKeepsEveryBit) {
  uint64_t before = 0;
  for (uint64_t k = 0; k < 30; ++k) {
    const uint64_t n = k % 10 == 9 ? 300000 : 1 + 37 * k;
    const Scene scene = make_scene({.name = "uniform", .n = n}), other = make_scene({.n = n});
    vulkan_->upload(scene);
    cuda_->upload(other);
    Exchange(*vulkan_, *cuda_, Transfer::imported).run();
    ASSERT_TRUE(has_positions(*cuda_, scene)) << n;
    vulkan_->upload(other);
    Exchange(*cuda_, *vulkan_, Transfer::imported).run();
    ASSERT_TRUE(has_positions(*vulkan_, scene)) << n;
    if (k == 0) before = open_descriptors();
  }
  EXPECT_LT(open_descriptors(), before + 10) << "of 58 exchanges";
}

TEST(ExchangeErrors, SayWhatIsMissing) {
  const std::vector<Backend*> all = gpu_apis();
  if (all.size() < 2) GTEST_SKIP() << "fewer than two GPU APIs";
  Backend &opengl = *all[0], &other = *all[1], &cpu = *find_backend("cpu");
  for (Backend* each : {&opengl, &other, &cpu}) each->upload(make_scene({.n = 10}));
  EXPECT_NE(complaint(opengl, other, Transfer::imported).find("transfer spheres as host"), std::string::npos);
  EXPECT_NE(complaint(opengl, other, Transfer::registered).find("as host or imported"), std::string::npos);
  EXPECT_NE(complaint(cpu, other, Transfer::host).find("cpu: "), std::string::npos);
  Exchange exchange(opengl, other, Transfer::host);
  other.upload(make_scene({.n = 11}));
  const std::string sizes = complaint(opengl, other, Transfer::host);
  EXPECT_NE(sizes.find("holds 10 spheres but"), std::string::npos) << sizes;
  EXPECT_THROW(exchange.run(), BackendError);
  opengl.upload(make_scene({.n = 11}));
  EXPECT_THROW(exchange.run(), BackendError) << "as many as the other, but not as before";
}

TEST(ExchangeErrors, SoftwareVulkanSharesNothingWithCuda) {
  Backend* cuda = find_backend("cuda");
  if (!cuda) GTEST_SKIP() << "needs CUDA";
  std::unique_ptr<Backend> software;
  try {
    software = open_backend("vulkan", {.allow_gpu = false});
  } catch (const BackendError& error) {
    GTEST_SKIP() << error.what();
  }
  for (Backend* each : {cuda, software.get()}) each->upload(make_scene({.n = 10}));
  const std::string said = complaint(*software, *cuda, Transfer::imported);
  EXPECT_NE(said.find("Vulkan runs in software"), std::string::npos) << said;
}

}  // namespace
}  // namespace spherepair
