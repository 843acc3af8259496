// SPDX-License-Identifier: MIT
// Asking for results only reads what a step completed: it launches nothing and repeats nothing.
#include "common/scene/camera.h"
#include "tests/support/grid_results.h"

namespace spherepair {
namespace {

class Questions : public BackendTest {
 protected:
  View view_of(const Scene& scene) {
    return make_view(frame(bounds_of(scene.positions), 30, 20, 50, 1.5), contact_look(), 90, 60);
  }
  Scene anchored(uint64_t n) {
    return make_scene({.name = "random", .n = n, .motion = {MotionMethod::anchored, Precision::float64}});
  }
  std::string complaint(const std::function<void()>& question) {
    try {
      question();
    } catch (const BackendError& error) {
      return error.what();
    }
    return "";
  }
  void expect_refused(const std::function<void()>& question, const std::string& what_to_do) {
    EXPECT_NE(complaint(question).find(what_to_do), std::string::npos) << complaint(question);
  }
};

TEST_P(Questions, LaunchNothing) {
  const Scene scene = anchored(3000);
  backend().upload(scene);
  for (const Method method : {Method::collide_triangle, Method::collide_grid}) {
    backend().move();
    backend().evaluate_state();
    backend().collide({.method = method, .want_pairs = true});
    drawing().draw(view_of(scene), {.count = true, .keep_visible = true});
    const WorkCounts before = backend().work_counts();
    for (int time = 0; time < 2; ++time) {
      EXPECT_EQ(backend().collisions().pairs, backend().pairs().size());
      EXPECT_EQ(backend().counts().size(), scene.size());
      EXPECT_EQ(backend().state().positions.size(), scene.size());
      EXPECT_EQ(drawing().image().size(), drawing().visible().size());
      EXPECT_GT(drawing().draw_statistics().drawn, 0u);
    }
    EXPECT_EQ(backend().work_counts().launches, before.launches) << method_name(method);
    EXPECT_EQ(backend().work_counts().steps, before.steps) << method_name(method);
  }
}

TEST_P(Questions, AreRefusedWhereTheStepWasOnlyEnqueued) {
  if (backend().info().on_host) GTEST_SKIP() << "the CPU enqueues nothing";
  const Scene scene = anchored(500);
  backend().upload(scene);
  backend().collide({.method = Method::collide_grid, .want_pairs = true});
  backend().enqueue_collide({.method = Method::collide_grid, .want_pairs = true});
  expect_refused([&] { backend().collisions(); }, "call collide");
  expect_refused([&] { backend().counts(); }, "call collide");
  expect_refused([&] { backend().pairs(); }, "call collide");
  expect_refused([&] { drawing().draw(view_of(scene), {}); }, "call collide");
  drawing().enqueue_draw(view_of(scene), {});
  expect_refused([&] { drawing().image(); }, "call draw");
  backend().collide({.method = Method::collide_grid, .want_pairs = true});
  drawing().draw(view_of(scene), {});
  EXPECT_EQ(complaint([&] { drawing().image(), backend().pairs(); }), "");
}

TEST_P(Questions, AreRefusedAboutWhatWasNotKept) {
  const Scene scene = anchored(500);
  backend().upload(scene);
  backend().move();
  expect_refused([&] { backend().state(); }, "call evaluate_state");
  backend().evaluate_state();
  EXPECT_EQ(complaint([&] { backend().state(); }), "");
  expect_refused([&] { backend().collisions(); }, "call collide");
  backend().collide({.method = Method::collide_grid});
  expect_refused([&] { backend().pairs(); }, "want_pairs");
  drawing().draw(view_of(scene), {});
  expect_refused([&] { drawing().visible(); }, "keep_visible");
  expect_refused([&] { drawing().draw_statistics(); }, "set count");
}

INSTANTIATE_BACKENDS(Questions);

}  // namespace
}  // namespace spherepair
