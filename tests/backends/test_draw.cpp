// SPDX-License-Identifier: MIT
// The rasteriser: every backend's image equals, to the bit, that of every sphere tested at every pixel.
#include <fmt/format.h>

#include <cmath>
#include <set>

#include "common/shared/draw.h"
#include "tests/oracle/oracle.h"
#include "tests/support/images.h"

namespace spherepair {
namespace {

constexpr uint width = 157, height = 83;  // no multiple of a group or a tile

class Draw : public KernelTest {
 protected:
  void expect_image(const Scene& scene, const View& view, const std::string& what) {
    std::vector<uint> contacts(scene.size());
    for (const Pair& pair : brute_force_pairs(scene.positions)) ++contacts[pair.first], ++contacts[pair.second];
    backend().upload(scene);
    const Image expected = brute_force_image(scene.positions, contacts, view);
    for (const Method method : {fast_method(backend()).method, Method::collide_grid}) {
      backend().collide({.method = method});
      EXPECT_EQ(first_mismatch(image_of(backend(), view), expected, view), "") << what << ", " << method_name(method);
    }
  }

  DrawStatistics counts_of(const View& view) {
    drawing().draw(view, {.count = true});
    return drawing().draw_statistics();
  }
};

View view_of(const Camera& camera, std::array<double, 2> jitter = {}) {
  return make_view(camera, contact_look(), width, height, jitter);
}

Camera framed(const Scene& scene) { return frame(bounds_of(scene.positions), 30, 20, 40, double(width) / height); }

// From the middle of the spheres outwards.
Camera inside(const Scene& scene, double near) {
  Camera camera = framed(scene);
  camera.eye = camera.target;
  camera.target = {camera.eye[0] + 3, camera.eye[1] + 0.5, camera.eye[2] + 1};
  camera.near = near;
  return camera;
}

TEST_P(Draw, EverySceneFromOutsideAndInside) {
  double near = 0;
  for (const SceneKind& kind : scene_kinds()) {
    const Scene scene = make_scene({.name = kind.name, .n = is_gpu(backend()) ? 700u : 250u});
    expect_image(scene, view_of(framed(scene)), fmt::format("{} from outside", kind.name));
    near = 2 - near;
    expect_image(scene, view_of(inside(scene, near)), fmt::format("{} from inside, near {}", kind.name, near));
  }
}

TEST_P(Draw, NoneOneAndTwo) {
  for (uint64_t n : {0, 1, 2}) {
    const Scene scene = make_scene({.n = n});
    expect_image(scene, view_of(framed(scene)), fmt::format("{} spheres", n));
    EXPECT_EQ(counts_of(view_of(framed(scene))).drawn, n);
  }
}

// Only draw() evaluates the positions.
TEST_P(Draw, AnchoredSpheresWhereTheyAreNow) {
  const Scene scene = make_scene({.n = 300, .motion = {.method = MotionMethod::anchored}});
  const View view = view_of(framed(scene));
  backend().upload(scene);
  for (int step = 0; step < 20; ++step) backend().move();
  const Image seen = image_of(backend(), view);
  const std::vector<vec4> now = current_state(backend()).positions;
  EXPECT_EQ(first_mismatch(seen, brute_force_image(now, std::vector<uint>(now.size()), view), view), "");
}

// From a point to twenty screens: all three classes of size, and the border between each two.
TEST_P(Draw, EverySizeOnTheScreen) {
  for (float ratio : {1.0f, 3e4f}) {
    const Scene scene = make_scene({.name = "uniform", .n = 500, .radius = 0.5f / ratio, .radius_ratio = ratio});
    Camera camera = framed(scene);
    const Vector eye = camera.eye, target = camera.target;
    for (double distance : {1000.0, 60.0, 3.0, 0.8}) {
      for (int a = 0; a < 3; ++a) camera.eye[a] = target[a] + (eye[a] - target[a]) * distance;
      expect_image(scene, view_of(camera, {0.3, -0.4}), fmt::format("ratio {}, {} times as far", ratio, distance));
    }
  }
}

// Spheres that the eye's plane cuts: in front of, next to and around the eye.
TEST_P(Draw, AcrossThePlaneOfTheEye) {
  std::vector<vec4> spheres;
  for (int i = 0; i < 300; ++i)
    spheres.push_back({float(i % 20) - 10, float(i / 20) - 7.5f, float(i % 7) * 0.25f - 0.75f, 0.3f + float(i % 5)});
  spheres.push_back({0, 0, 0, 100});  // the eye is inside
  spheres.push_back({0, 0, -2, 1});   // the eye's axis is tangent to nothing, and the sphere ahead
  for (double near : {1e-4, 0.5})
    for (double field : {20.0, 120.0})
      expect_image(scene_of(spheres), view_of({{0.1, 0.2, 0}, {0, 0, -5}, {0, 1, 0}, field, near}),
                   fmt::format("near {}, field {}", near, field));
}

// More tiles than the list has room for at first.
TEST_P(Draw, ManySpheresFillTheScreen) {
  std::vector<vec4> spheres(4400, vec4{0, 0, -10, 9});
  for (size_t i = 0; i < spheres.size(); ++i) spheres[i].x = float(i % 7) / 1024;
  const View view = view_of({{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 40, 0.01});
  backend().upload(scene_of(spheres));
  const DrawStatistics counts = counts_of(view);
  EXPECT_EQ(counts.large, spheres.size());
  EXPECT_GT(counts.tiles, 65536u);
  const Image expected = brute_force_image({spheres.begin(), spheres.begin() + 7}, std::vector<uint>(7), view);
  EXPECT_EQ(first_mismatch(image_of(backend(), view), expected, view),
            "");  // of equal depths the lowest number is seen
}

TEST_P(Draw, WhatCannotBeDrawnIsCounted) {
  Scene scene = make_scene({.name = "uniform", .n = 50});
  const View view = view_of(framed(scene));
  scene.positions[3].w = 0;
  scene.positions[4].w = 1e-20f;
  scene.positions[5].x = 1e20f;
  scene.positions[6] = {0, 0, 0, 1e30f};
  scene.equal_radii = false;
  expect_image(scene, view, "four undrawable");
  const DrawStatistics counts = counts_of(view);
  EXPECT_EQ(counts.undrawable, 4u);
  EXPECT_EQ(counts.drawn, 46u);
  EXPECT_EQ(counts.unseen, 0u);
}

// Contacts belong to the last collision step, and a move forgets them.
TEST_P(Draw, ColoursFollowTheSteps) {
  const Scene scene = make_scene({.n = 3000});
  const View view = view_of(framed(scene));
  backend().upload(scene);
  for (int step = 0; step < 3; ++step) {
    backend().move();
    const std::vector<vec4> positions = current_state(backend()).positions;
    Image expected = brute_force_image(positions, std::vector<uint>(scene.size()), view);
    EXPECT_EQ(first_mismatch(image_of(backend(), view), expected, view), "") << "moved, step " << step;
    backend().collide({.method = Method::collide_grid});
    expected = brute_force_image(positions, backend().counts(), view);
    EXPECT_EQ(first_mismatch(image_of(backend(), view), expected, view), "") << "collided, step " << step;
  }
}

// How many limits each sphere's value has reached.
std::vector<uint> entries_of(const Motion::State& state, const Look& look) {
  std::vector<uint> entries;
  for (size_t i = 0; i < state.positions.size(); ++i) {
    const vec4& v = state.velocities[i];
    const double speed = std::sqrt(double(v.x) * v.x + double(v.y) * v.y + double(v.z) * v.z);
    const double value = look.colour_by == COLOUR_BY_SPEED ? speed : double(state.positions[i].w);
    entries.push_back(uint(std::ranges::count_if(look.limits, [&](double limit) { return value >= limit; })));
  }
  return entries;
}

TEST_P(Draw, ColoursShowSpeedOrRadius) {
  for (const MotionMethod method : {MotionMethod::paper, MotionMethod::anchored}) {
    Scene scene = make_scene({.name = "random", .n = 2000, .radius_ratio = 4});
    scene.motion.method = method;
    backend().upload(scene);
    for (int step = 0; step < 2; ++step) {
      backend().move();
      backend().collide({.method = Method::collide_grid});
      const float least = std::ranges::min(scene.positions, {}, &vec4::w).w;
      for (const Look& look : {range_look(COLOUR_BY_SPEED, 0, 3), range_look(COLOUR_BY_RADIUS, least, 4 * least)}) {
        const View view = make_view(framed(scene), look, width, height);
        const Image given = image_of(backend(), view);
        const Motion::State state = current_state(backend());
        const std::vector<uint> entries = entries_of(state, look);
        EXPECT_EQ(std::set<uint>(entries.begin(), entries.end()).size(), size_t(COLOURS));
        EXPECT_EQ(first_mismatch(given, brute_force_image(state.positions, entries, view), view), "")
            << "step " << step << ", by " << look.colour_by;
      }
    }
  }
}

TEST_P(Draw, RefusesWhatIsNoView) {
  backend().upload(make_scene({.n = 10}));
  EXPECT_THROW(drawing().image(), BackendError);
  EXPECT_THROW(drawing().draw(View{}, {}), std::invalid_argument);
  EXPECT_THROW(view_of({{1, 2, 3}, {1, 2, 3}}), std::invalid_argument);
  EXPECT_THROW(view_of({{0, 5, 0}, {0, 0, 0}}), std::invalid_argument);
}

INSTANTIATE_BACKENDS(Draw);

// What decides a pixel is near the true value at least.
TEST(DrawArithmetic, RootAndReciprocal) {
  for (uint bits = 0x04000000u; bits < 0x7B000000u; bits += 9973) {
    const float x = bits_float(bits);
    EXPECT_NEAR(double(same_reciprocal(x)) * double(x), 1, 0x1p-21) << x;
    if (x >= 0x1p-100f) {
      EXPECT_NEAR(double(same_root(x)) / std::sqrt(double(x)), 1, 0x1p-21) << x;
    }
  }
  EXPECT_EQ(same_root(0.0f), 0.0f);
}

}  // namespace
}  // namespace spherepair
