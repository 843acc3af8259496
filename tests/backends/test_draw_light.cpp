// SPDX-License-Identifier: MIT
// Ambient occlusion, shadows and the ground: what is found through the cells equals every sphere tried at every pixel.
#include <fmt/format.h>

#include "common/scene/scene_params.h"
#include "common/shared/light.h"
#include "tests/support/images.h"

namespace spherepair {
namespace {

constexpr uint width = 93, height = 61;

class DrawLight : public BackendTest {};

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
  const float ground = v.lighting & LIGHT_GROUND ? depth_of_ground(ray, p.motion.plane, v) : 0;
  const bool sphere = seen.y != ~0u && !(ground > 0 && ground < bits_float(seen.y));
  if (!sphere && ground == 0) return lit(v.background, 1);
  Normal normal = {};
  if (sphere) normal = normal_at(in_camera(scene.positions[seen.x], v), ray, bits_float(seen.y));
  const Surface s =
      sphere ? surface_of(scene.positions[seen.x], seen.x, normal, v) : ground_at(ray, ground, p.motion.plane, v);
  const float around = v.lighting & LIGHT_OCCLUSION ? light_around(s, scene, p) : 1;
  const float sun = v.lighting & LIGHT_SHADOW && in_shadow(s, scene, v) ? 0.0f : 1.0f;
  return sphere ? lit(palette(contacts[seen.x], v), light_on_normal(normal, around, sun, v))
                : ground_colour(around, sun, v);
}

Image expected_image(const Scene& scene, const std::vector<uint>& contacts, const View& view) {
  Image image = brute_force_image(scene.positions, contacts, view);
  Params p{};
  p.motion = motion_params(scene);
  p.grid = grid_params(plan_grid(scene, Cells::dense));
  for (uint pixel = 0; pixel < image.image.size(); ++pixel)
    image.image[pixel] = colour_of(image.visible[pixel], pixel, scene, contacts, p, view);
  return image;
}

View view_of(const Scene& scene, uint lighting, double azimuth) {
  Look look = contact_look();
  look.lighting = lighting;
  return make_view(frame(bounds_of(scene.positions), azimuth, 25, 40, double(width) / height), look, width, height);
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
  const Backend::State state = current_state(backend());
  scene.positions = state.positions, scene.velocities = state.velocities;
  EXPECT_NE(plan_grid(scene, Cells::dense).side, before.side) << "the cells are the same: this shows nothing";
  backend().resume(scene, saved);
  EXPECT_EQ(first_mismatch(image(), expected, view), "");
}

TEST_P(DrawLight, NeedsTheDenseCells) {
  const Scene scene = make_scene({.n = 300});
  const View view = view_of(scene, LIGHT_OCCLUSION, 30);
  backend().upload(scene);
  EXPECT_THROW(backend().draw(view, {}), std::invalid_argument);
  backend().collide({.method = Method::collide_grid, .grid = {.cells = Cells::hashed}});
  EXPECT_THROW(backend().draw(view, {}), std::invalid_argument);
  backend().collide({.method = Method::collide_grid, .grid = {.cells = Cells::dense}});
  EXPECT_NO_THROW(backend().draw(view, {}));
  backend().move();
  EXPECT_THROW(backend().draw(view, {}), std::invalid_argument);
}

INSTANTIATE_BACKENDS(DrawLight);

}  // namespace
}  // namespace spherepair
