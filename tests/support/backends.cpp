// SPDX-License-Identifier: MIT
#include "tests/support/backends.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include "api/open.h"
#include "tests/oracle/oracle.h"
#include "tests/support/catalogue.h"

namespace spherepair {

std::vector<OpenedBackend>& all_backends() {
  static std::vector<OpenedBackend> backends = [] {
    std::vector<OpenedBackend> opened;
    for (const std::string& name : backend_names()) {
      OpenedBackend& entry = opened.emplace_back();
      entry.name = name;
      try {
        entry.backend = open_backend(name);
      } catch (const BackendError& error) {
        entry.reason = error.what();
      }
    }
    return opened;
  }();
  return backends;
}

std::vector<Backend*> open_backends() {
  std::vector<Backend*> there;
  for (OpenedBackend& entry : all_backends())
    if (entry.backend) there.push_back(entry.backend.get());
  return there;
}

bool backend_required(const std::string& name) {
  const char* list = std::getenv("REQUIRE_BACKENDS");
  if (!list) return false;
  std::istringstream names(list);
  for (std::string one; std::getline(names, one, ',');)
    if (backend_id(one) == name) return true;
  return false;
}

namespace {

bool is_form(const char* name) {
  const char* form = std::getenv("STRESS");
  return form && std::strcmp(form, name) == 0;
}

}  // namespace

bool full_stress() { return is_form("full"); }
bool short_stress() { return is_form("short"); }

std::string& device_option(OpenOptions& options, const std::string& backend) {
  return backend == "cuda" ? options.cuda_device : backend == "vulkan" ? options.vulkan_device : options.gl_device;
}

std::string last_gpu(const std::string& backend) {
  for (uint number = 16; number-- > 0;) try {
      OpenOptions options;
      device_option(options, backend) = std::to_string(number);
      if (const auto opened = open_backend(backend, options); is_gpu(*opened)) return opened->info().uuid;
    } catch (const BackendError&) {  // there are fewer
    }
  return {};
}

bool replays_steps(const Backend& backend) { return backend.info().name == "cuda" || backend.info().name == "vulkan"; }

bool is_gpu(const Backend& backend) { return !backend.info().on_host && !backend.info().software; }

std::vector<CollideOptions> every_method(const Backend& backend, std::span<const uint> blocks) {
  std::vector<CollideOptions> all;
  for (Method method : backend.methods()) {
    const bool blocked =
        method == Method::collide_group || (!backend.info().on_host && method != Method::collide_tensor);
    for (uint block : blocked ? blocks : blocks.first(1)) all.push_back({.method = method, .block = block});
  }
  return all;
}

CollideOptions fast_method(const Backend& backend) {
  return {.method = backend.info().on_host ? Method::parallel : Method::collide_triangle};
}

uint64_t hash_of_state(Motion& motion) {
  const Motion::State state = current_state(motion);
  return state_hash(state.positions, state.velocities, state.wide);
}

std::string describe(const CollideOptions& options) {
  constexpr const char* cells[] = {"", ", dense cells", ", hashed cells"};
  constexpr const char* sorts[] = {"", ", sorted by counting", ", sorted by buckets"};
  const GridOptions& grid = options.grid;
  return fmt::format("{} with groups of {}{}{}{}{}{}{}", method_name(options.method), options.block,
                     options.exact ? "" : ", naive", options.want_pairs ? ", listing pairs" : "",
                     cells[size_t(grid.cells)], sorts[size_t(grid.sort)], grid.keep_order ? "" : ", order not kept",
                     grid.keep_cells ? "" : ", cells not kept");
}

void BackendTest::SetUp() {
  for (OpenedBackend& entry : all_backends()) {
    if (entry.name != GetParam()) continue;
    backend_ = entry.backend.get();
    if (backend_) return;
    if (backend_required(entry.name))
      FAIL() << "the required backend " << entry.name << " is missing: " << entry.reason;
    GTEST_SKIP() << "no backend " << entry.name << ": " << entry.reason;
  }
}

void KernelTest::SetUp() {
  BackendTest::SetUp();
  if (IsSkipped() || HasFatalFailure() || GetParam() != "vulkan" || !backend().info().software) return;
  const auto opengl = std::ranges::find(all_backends(), "opengl", &OpenedBackend::name);
  if (opengl->backend && !full_stress() && !backend_required("vulkan"))
    GTEST_SKIP() << "in software Vulkan's kernels are OpenGL's; REQUIRE_BACKENDS=vulkan or STRESS=full runs them";
}

std::string parameter_name(const testing::TestParamInfo<std::string>& info) { return info.param; }

StepResult run_step(Backend& backend, const CollideOptions& options) {
  backend.collide(options);
  backend.check_guards();  // before lists that were too short are replaced by longer ones
  const StepResult answer = result_of(backend, options.want_pairs);
  backend.check_guards();
  return answer;
}

namespace {

std::string count_mismatch(const StepResult& answer, std::span<const Pair> expected, size_t spheres) {
  if (answer.counts.size() != spheres)
    return fmt::format("counts of {} spheres, not of {}", answer.counts.size(), spheres);
  std::vector<uint> counts(spheres);
  for (const Pair& pair : expected) ++counts[pair.first], ++counts[pair.second];
  const auto [given, wanted] = std::mismatch(answer.counts.begin(), answer.counts.end(), counts.begin());
  if (wanted != counts.end())
    return fmt::format("sphere {} has {} contacts, not {}", wanted - counts.begin(), *given, *wanted);
  const uint64_t flagged = uint64_t(std::count_if(counts.begin(), counts.end(), colliding));
  if (answer.totals.colliding_spheres != flagged)
    return fmt::format("{} colliding spheres, not {}", answer.totals.colliding_spheres, flagged);
  return {};
}

}  // namespace

std::string first_mismatch(const StepResult& answer, std::span<const Pair> expected, size_t spheres) {
  const auto difference = answer.pairs ? first_difference(*answer.pairs, expected) : std::nullopt;
  if (difference)
    return fmt::format("pair ({}, {}) is {}", difference->pair.first, difference->pair.second,
                       difference->in_left ? "too much" : "missing");
  if (answer.totals.pairs != expected.size())
    return fmt::format("{} pairs, not {}", answer.totals.pairs, expected.size());
  if (answer.totals.fingerprint != fingerprint(expected)) return "the fingerprint is that of another set";
  uint64_t settled = 0;
  for (uint64_t stage : answer.totals.decided_by) settled += stage;
  if (settled != answer.totals.deferred)
    return fmt::format("{} pairs deferred but {} settled", answer.totals.deferred, settled);
  return count_mismatch(answer, expected, spheres);
}

Scene scene_of(std::vector<vec4> spheres) {
  Scene scene;
  scene.name = "test";
  scene.velocities.resize(spheres.size(), vec4{0, 0, 0, 0});
  scene.equal_radii = std::all_of(spheres.begin(), spheres.end(), [&](const vec4& sphere) {
    return float_bits(sphere.w) == float_bits(spheres.front().w);
  });
  scene.positions = std::move(spheres);
  return scene;
}

void expect_pairs(Backend& backend, const Scene& scene, std::span<const Pair> expected,
                  const std::vector<CollideOptions>& methods) {
  backend.upload(scene);
  for (CollideOptions options : methods) {
    const std::vector<Pair> in_groups =
        options.method == Method::collide_group ? within_groups(expected, options.block) : std::vector<Pair>();
    const std::span<const Pair> wanted = options.method == Method::collide_group ? in_groups : expected;
    for (bool want_pairs : {false, true}) {
      options.want_pairs = want_pairs;
      count_figure("answers");
      EXPECT_EQ(first_mismatch(run_step(backend, options), wanted, scene.size()), "")
          << backend.info().name << ", scene " << scene.name << " of " << scene.size() << ", " << describe(options);
    }
  }
}

}  // namespace spherepair
