// SPDX-License-Identifier: MIT
// Two backends of one API in one process, opened and used as the library does it: on the API's first and last GPU if it
// reaches two, else twice on one device. Each keeps its own scene and gives its own answers.
#include "api/c/guarded.h"
#include "common/scene/camera.h"
#include "tests/support/backends.h"

namespace spherepair {
namespace {

struct Opened {
  Opened(const std::string& name, const std::string& device)
      : backend(open_for_calls(name.c_str(), device.c_str(), 1)) {}
  ~Opened() { close_for_calls(backend); }
  std::unique_ptr<Backend> backend;
};

class TwoBackends : public BackendTest {
 protected:
  // The thread has no context of the shared backend while two others are used.
  void SetUp() override {
    BackendTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    const std::string last = is_gpu(backend()) ? last_gpu(GetParam()) : "";
    if (!last.empty()) devices_ = {"0", last};
    backend().leave_thread();
    shared_ = &backend();
  }
  void TearDown() override {
    if (shared_) shared_->enter_thread();
  }
  Backend* shared_ = nullptr;
  std::array<std::string, 2> devices_;  // empty: the API's first
};
INSTANTIATE_BACKENDS(TwoBackends);

struct Answer {
  StepResult found;
  uint64_t state;
  std::vector<uint> image;
};

void draw(Backend& backend, const Scene& scene) {
  const Camera camera = frame(bounds_of(scene.positions), 30, 20, 40, 1);
  drawing_of(backend).draw(make_view(camera, contact_look(), 64, 64), {});
}

Answer answer_of(Backend& backend) {
  return {result_of(backend, true), hash_of_state(backend), drawing_of(backend).image()};
}

TEST_P(TwoBackends, GiveEachItsOwnAnswersWhenCallsInterleave) {
  constexpr int steps = 3;
  const CollideOptions listed{.method = Method::collide_grid, .want_pairs = true};
  // Moved by one method: the buffers of both backends have the same names.
  const Scene scenes[] = {make_scene({.name = "uniform", .n = 3000, .packing_fraction = 0.2}),
                          make_scene({.name = "clustered", .n = 1700, .seed = 5, .radius_ratio = 7})};
  std::vector<Answer> expected[2];
  Backend& cpu = *all_backends().front().backend;
  for (size_t k = 0; k < 2; ++k) {
    cpu.upload(scenes[k]);
    for (int step = 0; step < steps; ++step) {
      cpu.move(), cpu.collide(listed), draw(cpu, scenes[k]);
      expected[k].push_back(answer_of(cpu));
    }
  }
  const Opened opened[] = {{GetParam(), devices_[0]}, {GetParam(), devices_[1]}};
  const auto in_turn = [&](const auto& work) {
    for (size_t k = 0; k < 2; ++k) {
      const InThread in_thread(*opened[k].backend);
      work(*opened[k].backend, k);
    }
  };
  in_turn([&](Backend& one, size_t k) { one.upload(scenes[k]); });
  for (int step = 0; step < steps; ++step) {
    in_turn([](Motion& one, size_t) { one.move(); });
    in_turn([&](Search& one, size_t) { one.collide(listed); });
    in_turn([&](Backend& one, size_t k) { draw(one, scenes[k]); });
    in_turn([&](Backend& one, size_t k) {
      const Answer answer = answer_of(one), &wanted = expected[k][step];
      EXPECT_GT(wanted.found.totals.pairs, 0u);
      EXPECT_TRUE(same_result(answer.found, wanted.found)) << "scene " << k << ", step " << step;
      EXPECT_EQ(answer.state, wanted.state) << "scene " << k << ", step " << step;
      EXPECT_TRUE(answer.image == wanted.image) << "scene " << k << ", step " << step;
      one.check_guards();
    });
  }
}

TEST_P(TwoBackends, SitOnTwoGpusIfTheApiReachesTwo) {
  const Opened first(GetParam(), devices_[0]), second(GetParam(), devices_[1]);
  const std::string one = first.backend->info().uuid, other = second.backend->info().uuid;
  if (devices_[1].empty() || one == devices_[1]) GTEST_SKIP() << "one device: " << first.backend->info().device;
  EXPECT_EQ(other, devices_[1]);
  EXPECT_NE(one, other);
}

}  // namespace
}  // namespace spherepair
