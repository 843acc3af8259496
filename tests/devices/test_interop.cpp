// SPDX-License-Identifier: MIT
// Spheres of CUDA and of the CPU drawn through OpenGL: whichever way they come there, the image is that of OpenGL's
// own.
#include "tests/support/images.h"

namespace spherepair {
namespace {

constexpr uint width = 320, height = 180;
constexpr DrawMethod through_opengl[] = {DrawMethod::mesh, DrawMethod::mesh_each, DrawMethod::quadric,
                                         DrawMethod::points, DrawMethod::impostor};

class Interop : public BackendTest {
 protected:
  void SetUp() override {
    BackendTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    for (Backend* each : open_backends())
      if (each->info().name == "opengl") glsl_ = each;
    if (const std::string why = why_no_pipeline(backend()); !why.empty()) GTEST_SKIP() << why;
    if (drawing().transfers().empty()) GTEST_SKIP() << "the spheres are OpenGL's own";
  }
  void show(const Scene& scene) {
    for (Backend* each : {&backend(), glsl_}) {
      each->upload(scene);
      each->collide({.method = Method::collide_grid});
    }
  }
  void move() {
    for (Backend* each : {&backend(), glsl_}) {
      each->move();
      each->collide({.method = Method::collide_grid});
    }
  }
  void expect_equal_images(const View& view, const std::string& what) {
    for (const DrawMethod method : through_opengl) {
      drawing_of(*glsl_).draw(view, {.method = method});
      const std::vector<uint> expected = drawing_of(*glsl_).image();
      const auto covered = std::ranges::count_if(expected, [&](uint pixel) { return pixel != expected.front(); });
      EXPECT_GT(uint64_t(covered), width * height / 50) << "a blank image, " << draw_method_name(method);
      for (const Transfer way : drawing().transfers()) {
        drawing().draw(view, {.method = method, .transfer = way});
        EXPECT_EQ(drawing().image(), expected)
            << what << ", " << transfer_name(way) << ", " << draw_method_name(method);
        EXPECT_EQ(drawing().transfer_taken(), way);
      }
    }
  }

  Backend* glsl_ = nullptr;
};

View view_of(const Scene& scene, const Look& look = contact_look()) {
  return make_view(frame(bounds_of(scene.positions), 30, 20, 40, double(width) / height), look, width, height);
}

TEST_P(Interop, EveryWayGivesTheImageOfOpenGLsOwnSpheres) {
  const Scene scene = make_scene({.n = 3000});
  show(scene);
  for (int step = 0; step < 3; ++step) {
    move();
    expect_equal_images(view_of(scene), "step " + std::to_string(step));
  }
}

TEST_P(Interop, FollowsScenesOfOtherSizesAndAnchoredMotion) {
  for (const uint64_t n : {200u, 5000u, 300u}) {
    Scene scene = make_scene({.n = n});
    scene.motion.method = MotionMethod::anchored;
    show(scene);
    move();
    expect_equal_images(view_of(scene), std::to_string(n) + " anchored spheres");
    expect_equal_images(view_of(scene, range_look(COLOUR_BY_SPEED, 0, 3)), "by speed");
  }
}

TEST_P(Interop, TheFastestWayIsTakenUnlessAnotherIsNamed) {
  const Scene scene = make_scene({.n = 100});
  show(scene);
  drawing().draw(view_of(scene), {.method = DrawMethod::mesh});
  EXPECT_EQ(drawing().transfer_taken(), drawing().transfers().back());
  drawing().draw(view_of(scene), {.method = DrawMethod::mesh, .transfer = Transfer::host});
  EXPECT_EQ(drawing().transfer_taken(), Transfer::host);
}

INSTANTIATE_BACKENDS(Interop);

TEST(InteropErrors, OpenGLsOwnSpheresAreNotTransferred) {
  for (Backend* backend : open_backends()) {
    if (backend->info().name != "opengl") continue;
    backend->upload(make_scene({.n = 10}));
    Drawing& drawing = drawing_of(*backend);
    EXPECT_TRUE(drawing.transfers().empty());
    EXPECT_THROW(drawing.transfer(Transfer::host), BackendError);
    const View view = view_of(make_scene({.n = 10}));
    EXPECT_THROW(drawing.draw(view, {.method = DrawMethod::mesh, .transfer = Transfer::host}), std::invalid_argument);
  }
}

TEST(InteropErrors, OnlyCudasSpheresAreSharedWithOpenGL) {
  for (Backend* backend : open_backends()) {
    if (!backend->info().on_host) continue;
    if (const std::string why = why_no_pipeline(*backend); !why.empty()) GTEST_SKIP() << why;
    backend->upload(make_scene({.n = 10}));
    const View view = view_of(make_scene({.n = 10}));
    EXPECT_THROW(drawing_of(*backend).draw(view, {.method = DrawMethod::mesh, .transfer = Transfer::imported}),
                 BackendError);
  }
}

TEST(InteropErrors, OpenGLDrawsForCudaOnlyOnCudasGpu) {
  OpenOptions options;
  options.cuda_device = "0";
  options.gl_device = last_gpu("opengl");
  if (options.gl_device.empty() || last_gpu("cuda") != options.gl_device) GTEST_SKIP() << "no GPU that both APIs reach";
  const auto cuda = open_backend("cuda", options);
  if (cuda->info().uuid == options.gl_device) GTEST_SKIP() << "one GPU";
  cuda->upload(make_scene({.n = 10}));
  EXPECT_THROW(drawing_of(*cuda).draw(view_of(make_scene({.n = 10})), {.method = DrawMethod::mesh}), BackendError);
}

}  // namespace
}  // namespace spherepair
