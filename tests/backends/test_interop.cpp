// SPDX-License-Identifier: MIT
// CUDA's spheres drawn through OpenGL: with every kind of transfer the image is that of OpenGL's own spheres.
#include "api/open.h"
#include "common/backend/shared_drawing.h"
#include "tests/support/images.h"

namespace spherepair {
namespace {

constexpr uint width = 320, height = 180;

Backend* open_one(const std::string& name) {
  for (Backend* backend : open_backends())
    if (backend->info().name == name) return backend;
  return nullptr;
}

TEST(Interop, EveryWayGivesTheSameImage) {
  Backend *cuda = open_one("cuda"), *glsl = open_one("glsl");
  if (!cuda || !glsl || !is_gpu(*glsl)) GTEST_SKIP() << "needs a GPU through both CUDA and OpenGL";
  const Scene scene = make_scene({.n = 3000});
  for (Backend* backend : {cuda, glsl}) backend->upload(scene);
  const std::unique_ptr<SharedDrawing> shared = open_shared_drawing(*cuda);
  for (int step = 0; step < 3; ++step) {
    for (Backend* backend : {cuda, glsl}) {
      backend->move();
      backend->collide({.method = Method::collide_grid});
    }
    const Camera camera = frame(bounds_of(scene.positions), 30, 20, 40, double(width) / height);
    const View view = make_view(camera, contact_look(), width, height);
    for (DrawMethod method : {DrawMethod::mesh, DrawMethod::points, DrawMethod::impostor}) {
      glsl->draw(view, {.method = method});
      const std::vector<uint> expected = glsl->image();
      const auto covered = std::ranges::count_if(expected, [&](uint pixel) { return pixel != expected.front(); });
      EXPECT_GT(uint64_t(covered), width * height / 50) << "a blank image, " << draw_method_name(method);
      for (Transfer way : {Transfer::host, Transfer::registered, Transfer::imported}) {
        shared->transfer(way);
        shared->draw(method, view);
        EXPECT_EQ(shared->image(), expected) << transfer_name(way) << ", " << draw_method_name(method);
      }
    }
  }
}

TEST(Interop, SaysWhatIsMissing) {
  Backend* cpu = open_one("cpu");
  cpu->upload(make_scene({.n = 10}));
  try {
    open_shared_drawing(*cpu);
    FAIL() << "the CPU's spheres were transferred";
  } catch (const BackendError& error) {
    EXPECT_NE(std::string(error.what()).find("CUDA"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace spherepair
