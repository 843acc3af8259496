// SPDX-License-Identifier: MIT
// The backends of this machine, opened once a process, and tests parametrised over them. A backend that is missing
// skips its tests with the reason; the environment variable REQUIRE_BACKENDS=cpu,opengl,vulkan,cuda makes that a
// failure.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "api/open.h"
#include "bench/check/step_result.h"

namespace spherepair {

struct OpenedBackend {
  std::string name;
  std::unique_ptr<Backend> backend;  // null when it is missing
  std::string reason;                // why it is missing
};
std::vector<OpenedBackend>& all_backends();
std::vector<Backend*> open_backends();  // the backends that opened
bool backend_required(const std::string& name);

// STRESS=full in the environment asks for sizes that take long without a GPU; STRESS=short asks for small sizes
// everywhere, as sanitizers need.
bool full_stress();
bool short_stress();

// `small` in the short form, and for a GPU's API in software unless the full form is wanted.
template <typename Size>
Size by_form(Size large, Size small) {
  return short_stress() ? small : large;
}
template <typename Size>
Size by_form(const Backend& backend, Size large, Size small) {
  return backend.info().software && !full_stress() ? small : by_form(large, small);
}

// Whether the backend can replay the launches of a step that it recorded.
bool replays_steps(const Backend& backend);

// Whether the backend is a GPU, which can take sizes that would take a CPU minutes.
bool is_gpu(const Backend& backend);

// The option that chooses the GPU of an API.
std::string& device_option(OpenOptions& options, const std::string& backend);

// The UUID of the last GPU that an API reaches, found by counting; empty if it reaches none.
std::string last_gpu(const std::string& backend);

// A backend's methods, with each of these group sizes. Methods without a group size come once: collide_tensor, and on
// the CPU all but collide_group.
std::vector<CollideOptions> every_method(const Backend& backend, std::span<const uint> blocks);
CollideOptions fast_method(const Backend& backend);
uint64_t hash_of_state(Motion& motion);  // of the current state: evaluates it, then reads it
std::string describe(const CollideOptions& options);

class BackendTest : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override;
  Backend& backend() { return *backend_; }
  Drawing& drawing() { return drawing_of(*backend_); }

 private:
  Backend* backend_ = nullptr;
};

// Tests of kernels' results, not of launches. In software one compiler makes Vulkan's and OpenGL's kernels: Vulkan then
// runs only with STRESS=full, or if REQUIRE_BACKENDS has vulkan.
class KernelTest : public BackendTest {
 protected:
  void SetUp() override;
};

// Rows of the stress catalogue that every backend must pass; each test is named by its row.
class StressCatalogue : public KernelTest {};

std::string parameter_name(const testing::TestParamInfo<std::string>& info);
#define INSTANTIATE_BACKENDS(suite) \
  INSTANTIATE_TEST_SUITE_P(Backends, suite, testing::ValuesIn(backend_names()), parameter_name)

StepResult run_step(Backend& backend, const CollideOptions& options);

// The first difference of an answer from the expected set, as a sentence; empty if there is none.
std::string first_mismatch(const StepResult& answer, std::span<const Pair> expected, size_t spheres);

// A scene of these spheres at rest; sets equal_radii from their radii.
Scene scene_of(std::vector<vec4> spheres);

// Runs the methods at the blocks on the scene and compares each with the expected pairs (for collide_group those within
// a group), with a list and, if other code then runs, also without one.
void expect_pairs(Backend& backend, const Scene& scene, std::span<const Pair> expected,
                  const std::vector<CollideOptions>& methods);

}  // namespace spherepair
