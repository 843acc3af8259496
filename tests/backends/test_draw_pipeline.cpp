// SPDX-License-Identifier: MIT
// The graphics pipeline: the three ways to draw the mesh give one image, impostors that of the rasteriser.
#include <fmt/format.h>

#include <set>

#include "common/scene/sphere_mesh.h"
#include "tests/support/images.h"

namespace spherepair {
namespace {

constexpr uint width = 320, height = 180;

class DrawPipeline : public BackendTest {
 protected:
  void SetUp() override {
    BackendTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    if (const std::string why = why_no_pipeline(backend()); !why.empty()) GTEST_SKIP() << why;
  }
  std::vector<uint> image(DrawMethod method, const View& view) {
    drawing().draw(view, {.method = method});
    return drawing().image();
  }
  void show(const Scene& scene) {
    backend().upload(scene);
    backend().collide({.method = Method::collide_grid});
  }
};

View view_of(const Scene& scene, double nearer = 1) {
  Camera camera = frame(bounds_of(scene.positions), 30, 20, 40, double(width) / height);
  for (int a = 0; a < 3; ++a) camera.eye[a] = camera.target[a] + (camera.eye[a] - camera.target[a]) * nearer;
  return make_view(camera, contact_look(), width, height);
}

size_t differences(const std::vector<uint>& left, const std::vector<uint>& right) {
  size_t count = 0;
  for (size_t k = 0; k < left.size(); ++k) count += left[k] != right[k];
  return count;
}

size_t covered(const std::vector<uint>& image) { return differences(image, std::vector<uint>(image.size(), ~0u)); }

TEST_P(DrawPipeline, TheMeshIsTheSameInOneDrawOrOneASphere) {
  for (const char* kind : {"random", "lattice", "clustered"}) {
    const Scene scene = make_scene({.name = kind, .n = 500, .radius_ratio = kind[0] == 'c' ? 5.0f : 1.0f});
    show(scene);
    for (double nearer : {1.0, 0.2}) {
      const View view = view_of(scene, nearer);
      const std::vector<uint> mesh = image(DrawMethod::mesh, view);
      EXPECT_GT(covered(mesh), mesh.size() / 50) << kind;
      EXPECT_EQ(differences(mesh, image(DrawMethod::mesh_each, view)), 0u) << kind;
    }
  }
}

TEST_P(DrawPipeline, ImpostorsAreTheRasterisersSpheres) {
  for (const char* kind : {"random", "uniform", "clustered"}) {
    const Scene scene = make_scene({.name = kind, .n = 1000});
    show(scene);
    for (double nearer : {1.0, 0.3}) {
      const View view = view_of(scene, nearer);
      const std::vector<uint> exact = image(DrawMethod::compute, view);
      EXPECT_GT(covered(exact), 100u) << kind;
      EXPECT_LE(differences(exact, image(DrawMethod::impostor, view)), exact.size() / 1000) << kind << ", " << nearer;
    }
    const Look by_radius = range_look(COLOUR_BY_RADIUS, 0, 2 * double(scene.positions.front().w));
    const View view =
        make_view(frame(bounds_of(scene.positions), 30, 20, 40, double(width) / height), by_radius, width, height);
    const std::vector<uint> exact = image(DrawMethod::compute, view);
    EXPECT_NE(exact, image(DrawMethod::compute, view_of(scene)));
    EXPECT_LE(differences(exact, image(DrawMethod::impostor, view)), exact.size() / 1000) << kind << " by radius";
  }
}

// 80 triangles cover less than the sphere does, and their outline is within it.
TEST_P(DrawPipeline, TheMeshIsSmallerThanTheSphere) {
  const Scene scene = scene_of({{0, 0, 0, 1}});
  show(scene);
  const View view = view_of(scene);
  const size_t sphere = covered(image(DrawMethod::compute, view)), mesh = covered(image(DrawMethod::mesh, view));
  EXPECT_LT(mesh, sphere);
  EXPECT_GT(double(mesh), 0.9 * double(sphere));
  EXPECT_NEAR(double(covered(image(DrawMethod::points, view))), double(sphere), 0.05 * double(sphere));
}

// 180 triangles of GLUT's sphere come closer than the paper's 80.
TEST_P(DrawPipeline, GlutsSphereIsBetweenMeshAndSphere) {
  show(scene_of({{0, 0, 0, 1}}));
  const View view = view_of(scene_of({{0, 0, 0, 1}}));
  const size_t sphere = covered(image(DrawMethod::compute, view)), quadric = covered(image(DrawMethod::quadric, view));
  EXPECT_LT(quadric, sphere);
  EXPECT_GT(double(quadric), 0.93 * double(sphere));
}

TEST_P(DrawPipeline, NothingAndWhatCannotBeDrawn) {
  for (const std::vector<vec4>& spheres : {std::vector<vec4>{}, {{0, 0, 0, 0}}, {{1e30f, 0, 0, 1}}}) {
    show(scene_of(spheres));
    const View view = make_view({{0, 0, 5}, {0, 0, 0}}, contact_look(), width, height);
    for (const DrawMethod method : all_draw_methods())
      EXPECT_EQ(covered(image(method, view)), 0u) << draw_method_name(method);
  }
}

INSTANTIATE_BACKENDS(DrawPipeline);

// Every edge is shared by two triangles, which see it from opposite ends; none is turned inwards.
void expect_closed_sphere(const SphereMesh& mesh, double expected_volume) {
  std::set<std::pair<unsigned, unsigned>> edges;
  for (size_t k = 0; k < mesh.indices.size(); k += 3)
    for (size_t side = 0; side < 3; ++side) {
      const unsigned from = mesh.indices[k + side], to = mesh.indices[k + (side + 1) % 3];
      EXPECT_TRUE(edges.emplace(from, to).second) << "two triangles have the edge " << from << " to " << to;
    }
  for (const auto& [from, to] : edges) EXPECT_TRUE(edges.contains({to, from})) << "an open edge";
  double volume = 0;
  const std::vector<Corner> all = mesh.unindexed();
  for (size_t k = 0; k < all.size(); k += 3) {
    const auto &a = all[k], &b = all[k + 1], &c = all[k + 2];
    const double part = double(a[0]) * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                        a[2] * (b[0] * c[1] - b[1] * c[0]);
    EXPECT_GT(part, 0) << "triangle " << k / 3 << " is turned inwards";
    volume += part / 6;
  }
  EXPECT_NEAR(volume, expected_volume, 0.02);  // of a sphere 4.19
}

TEST(SphereMesh, IsThatOfThePaper) {
  const SphereMesh mesh = sphere_mesh();
  EXPECT_EQ(mesh.corners.size(), 42u);
  EXPECT_EQ(mesh.indices.size(), 240u);
  expect_closed_sphere(mesh, 3.66);
}

TEST(SphereMesh, OfGlutHasTenSlicesAndStacks) {
  const SphereMesh mesh = quadric_mesh();
  EXPECT_EQ(mesh.corners.size(), 2u + 9 * 10);
  EXPECT_EQ(mesh.indices.size(), 180u * 3);
  expect_closed_sphere(mesh, 3.82);
}

}  // namespace
}  // namespace spherepair
