// SPDX-License-Identifier: MIT
// Ambient occlusion, shadows and the ground: what is found through the cells equals every sphere tried at every pixel.
#include <fmt/format.h>

#include <set>

#include "common/scene/scene_params.h"
#include "common/shared/light.h"
#include "tests/support/images.h"

namespace spherepair {
namespace {

constexpr uint width = 93, height = 61;

class DrawLight : public KernelTest {};

float light_around(const Surface& s, const Scene& scene, const Params& p) {
  uint taken = 0;
  for (uint i = 0; i < scene.size(); ++i)
    if (i != s.sphere) taken += taken_by(scene.positions[i], s, p.grid);
  return light_left(taken);
}

bool in_shadow(const Surface& s, const Scene& scene, const View& v) {
  for (uint i = 0; i < scene.size(); ++i)
    if (i != s.sphere && shades(scene.positions[i], s, v)) return true;
  return false;
}

uint colour_of(uvec2 seen, uint pixel, const Scene& scene, const std::vector<uint>& contacts, const Params& p,
               const View& v) {
  const Ray ray = ray_through(pixel % v.width, pixel / v.width, v);
  const float ground = v.lighting & LIGHT_GROUND ? depth_of_ground(ray, v) : 0;
  const bool sphere = seen.y != ~0u && !(v.lighting & LIGHT_ALONE) && !(ground > 0 && ground < bits_float(seen.y));
  if (!sphere && ground == 0) return lit(v.background, 1);
  Normal normal = {};
  if (sphere) normal = normal_at(in_camera(scene.positions[seen.x], v), ray, bits_float(seen.y));
  const Surface s = sphere ? surface_of(scene.positions[seen.x], seen.x, normal, v) : ground_at(ray, ground, v);
  const float around = v.lighting & LIGHT_OCCLUSION ? light_around(s, scene, p) : 1;
  const float sun = v.lighting & LIGHT_SHADOW && in_shadow(s, scene, v) ? 0.0f : 1.0f;
  return sphere ? lit(palette(contacts[seen.x], v), light_on_normal(normal, around, sun, v))
                : ground_colour(around, sun, v);
}

Image expected_image(const Scene& scene, const std::vector<uint>& contacts, const View& view) {
  Image image = brute_force_image(scene.positions, contacts, view);
  Params p{};
  p.grid = grid_params(plan_grids(scene.positions).light);
  for (uint pixel = 0; pixel < image.image.size(); ++pixel)
    image.image[pixel] = colour_of(image.visible[pixel], pixel, scene, contacts, p, view);
  return image;
}

View view_of(const Scene& scene, uint lighting, double azimuth) {
  Look look = contact_look();
  look.lighting = lighting;
  look.ground = double(scene.plane);
  return make_view(frame(bounds_of(scene.positions), azimuth, 25, 40, double(width) / height), look, width, height);
}

// Radii from 2^-7 to 1, most of them small.
Scene scattered_scene() {
  Scene scene = make_scene({.name = "uniform", .n = 400});
  for (size_t i = 0; i < scene.size(); ++i) scene.positions[i].w = std::exp2(-float(i % 15 * (i % 3)) / 4);
  scene.equal_radii = false;
  return scene;
}

TEST_P(DrawLight, EqualsEverySphereTried) {
  for (const char* kind : {"random", "uniform"}) {
    Scene scene = make_scene({.name = kind, .n = 600});
    if (kind[0] == 'u') scene.plane = 1;  // cuts through the spheres
    backend().upload(scene);
    backend().collide({.method = Method::collide_grid, .grid = {.cells = Cells::dense}});
    for (uint lighting : {LIGHT_OCCLUSION, LIGHT_SHADOW, LIGHT_OCCLUSION | LIGHT_SHADOW | LIGHT_GROUND})
      for (double azimuth : {30.0, 200.0}) {
        const View view = view_of(scene, lighting, azimuth);
        const Image expected = expected_image(scene, backend().counts(), view);
        EXPECT_EQ(first_mismatch(image_of(backend(), view), expected, view), "") << kind << ", " << lighting;
        EXPECT_NE(first_mismatch(image_of(backend(), view_of(scene, 0, azimuth)), expected, view), "")
            << "no light shows";
      }
  }
}

// A run that goes on has its cells planned from other positions; its image depends on the spheres alone.
TEST_P(DrawLight, IsTheSameAfterAPause) {
  Scene scene = make_scene({.n = 300, .restitution = 0.25f});
  const View view = view_of(scene, LIGHT_OCCLUSION | LIGHT_SHADOW | LIGHT_GROUND, 30);
  const auto image = [&] {
    backend().collide({.method = Method::collide_grid, .grid = {.cells = Cells::dense}});
    return image_of(backend(), view);
  };
  backend().upload(scene);
  const GridPlan before = plan_grid(scene, Cells::dense);
  for (int step = 0; step < 250; ++step) backend().move();
  const Image expected = image();
  const MotionState saved = backend().save();
  const Motion::State state = current_state(backend());
  scene.positions = state.positions, scene.velocities = state.velocities;
  EXPECT_NE(plan_grid(scene, Cells::dense).side, before.side) << "the cells are the same: this shows nothing";
  backend().resume(scene, saved);
  EXPECT_EQ(first_mismatch(image(), expected, view), "");
}

// The light sorts the spheres itself where the search had no cells or others; counts stay those of the search.
TEST_P(DrawLight, IsTheSameWhateverWasSearched) {
  for (const bool scattered : {false, true}) {
    const Scene scene = scattered ? scattered_scene() : make_scene({.n = 300});
    const View view = view_of(scene, LIGHT_OCCLUSION | LIGHT_SHADOW | LIGHT_GROUND, 30);
    backend().upload(scene);
    backend().collide({.method = Method::collide_grid, .grid = {.cells = Cells::dense}});
    const std::vector<uint> counts = backend().counts();
    const Image expected = expected_image(scene, counts, view);
    for (const CollideOptions& options :
         {CollideOptions{.method = Method::collide_tiled},
          CollideOptions{.method = Method::collide_grid, .grid = {.cells = Cells::hashed}},
          CollideOptions{.method = Method::collide_grid, .grid = {.cells = Cells::dense}}}) {
      backend().collide(options);
      EXPECT_EQ(first_mismatch(image_of(backend(), view), expected, view), "") << scattered;
      EXPECT_EQ(backend().counts(), counts);
      EXPECT_EQ(first_mismatch(image_of(backend(), view), expected, view), "") << scattered;
    }
    backend().upload(scene);
    const std::vector<uint> none(scene.size());
    EXPECT_EQ(first_mismatch(image_of(backend(), view), expected_image(scene, none, view), view), "") << scattered;
  }
}

// Radii over seven octaves: each level of cells has some.
TEST_P(DrawLight, EqualsEverySphereTriedForScatteredRadii) {
  const Scene scene = scattered_scene();
  EXPECT_GE(plan_grids(scene.positions).light.top_level, 3u) << "one level: this shows nothing";
  backend().upload(scene);
  backend().collide({.method = Method::automatic});
  for (uint lighting : {LIGHT_OCCLUSION, LIGHT_SHADOW, LIGHT_OCCLUSION | LIGHT_SHADOW | LIGHT_GROUND | LIGHT_ALONE}) {
    const View view = view_of(scene, lighting, 30);
    const Image expected = expected_image(scene, backend().counts(), view);
    EXPECT_EQ(first_mismatch(image_of(backend(), view), expected, view), "") << lighting;
  }
}

// With another axis upwards the ground, the light and the shadows follow: every sphere tried says so, from every side
// of the sky. Sparse spheres throw their shadows far.
TEST_P(DrawLight, EqualsEverySphereTriedWhateverIsUp) {
  std::set<std::pair<uint, bool>> ways;  // to the sun: the axis along which it is farthest, and whether upwards
  for (const Scene& scene : {scattered_scene(), make_scene({.name = "uniform", .n = 200, .packing_fraction = 0.02})}) {
    backend().upload(scene);
    backend().collide({.method = Method::automatic});
    for (const Vector& up : {Vector{0, 0, 1}, Vector{0, 0, -1}, Vector{0, 1, 0}, Vector{0, -1, 0}, Vector{1, 0, 0},
                             Vector{-1, 0.3, 0.2}}) {
      Look look = contact_look();
      look.lighting = LIGHT_OCCLUSION | LIGHT_SHADOW | LIGHT_GROUND;
      look.ground_normal = up;
      look.ground = -1;
      const Camera camera = frame(bounds_of(scene.positions), 200, 25, 40, double(width) / height, up);
      const View view = make_view(camera, look, width, height);
      const uint axis = layer_axis(view);
      ways.insert({axis, on_axis(axis, view.sun.x, view.sun.y, view.sun.z) > 0});
      const Image expected = expected_image(scene, backend().counts(), view);
      EXPECT_EQ(first_mismatch(image_of(backend(), view), expected, view), "")
          << fmt::format("{}", fmt::join(up, ", "));
    }
  }
  EXPECT_EQ(ways.size(), 6u) << "not from every side";
}

INSTANTIATE_BACKENDS(DrawLight);

}  // namespace
}  // namespace spherepair
