// SPDX-License-Identifier: MIT
// Images one after the other: an image clears its pixels for the next, whatever that one's size and options are, and
// the launches for large spheres are left out only where no sphere is large.
#include <algorithm>
#include <random>

#include "common/shared/draw.h"
#include "tests/oracle/oracle.h"
#include "tests/support/images.h"

namespace spherepair {
namespace {

class DrawTurns : public DeviceImages {};

struct Shot {
  View view;
  Image expected;
};

// Of several sizes, from outside and inside, with and without light.
std::vector<Shot> shots(Backend& backend, const Scene& scene) {
  std::vector<Shot> all;
  const DrawOptions everything = {
      .frustum_culling = false, .occlusion_culling = false, .reuse_unchanged = false, .skip_tile_launches = false};
  for (const auto& [width, height] : {std::pair{61u, 40u}, {130u, 97u}, {90u, 55u}})
    for (const double nearer : {1.0, 0.3})
      for (const uint lighting : {0u, LIGHT_OCCLUSION | LIGHT_SHADOW | LIGHT_GROUND}) {
        Camera camera = frame(bounds_of(scene.positions), 40, 20, 50, double(width) / height);
        for (int a = 0; a < 3; ++a) camera.eye[a] = camera.target[a] + nearer * (camera.eye[a] - camera.target[a]);
        Look look = contact_look();
        look.lighting = lighting;
        look.ground = double(scene.plane);
        const View view = make_view(camera, look, width, height);
        all.push_back({view, image_of(backend, view, everything)});
      }
  return all;
}

TEST_P(DrawTurns, LeaveNothingToTheNext) {
  const Scene scene = make_scene({.name = "uniform", .n = 3000});
  const CollideOptions dense = {.method = Method::collide_grid, .grid = {.cells = Cells::dense}};
  backend().upload(scene);
  backend().collide(dense);
  const std::vector<Shot> all = shots(backend(), scene);
  std::minstd_rand random(7);
  for (int turn = 0; turn < by_form(backend(), 120, 60); ++turn) {
    if (turn % 40 == 20) {  // another scene, then this one: nothing of the last image is listed
      backend().upload(make_scene({.name = "uniform", .n = 50}));
      drawing().draw(all[0].view, {.clusters_from = 0});
      backend().upload(scene);
      backend().collide(dense);
    }
    const Shot& shot = all[random() % all.size()];
    DrawOptions options = {.reuse_unchanged = false, .count = random() % 2 == 0};
    options.frustum_culling = random() % 2;
    options.occlusion_culling = random() % 3 > 0;
    options.clusters_from = random() % 4 ? 0 : ~uint64_t(0);
    options.cull_from = random() % 3 ? 0 : ~uint64_t(0);
    options.defer_from = random() % 2 ? 0 : ~uint64_t(0);
    options.keep_visible = random() % 4 == 0;
    drawing().draw(shot.view, options);
    Image given{drawing().image(), shot.expected.visible};
    if (options.count) {
      const DrawStatistics counts = drawing().draw_statistics();
      EXPECT_GT(counts.drawn + counts.unseen, 0u) << turn;
      EXPECT_LE(counts.drawn + counts.unseen + counts.hidden, 2 * scene.size())
          << turn;  // seen, and then with a cluster
    }
    if (options.keep_visible) given.visible = drawing().visible();
    ASSERT_EQ(first_mismatch(given, shot.expected, shot.view), "") << turn;
  }
  backend().check_guards();
}

// Sphere indices of a larger scene, left where a small image of a smaller scene clears nothing, are not listed.
TEST_P(DrawTurns, ListNothingOfAnotherScene) {
  const auto view_of = [](const Scene& scene, uint width) {
    return make_view(frame(bounds_of(scene.positions), 30, 20, 50, 1.5), contact_look(), width, width * 2 / 3);
  };
  const Scene large = make_scene({.name = "uniform", .n = 700}), small = make_scene({.name = "uniform", .n = 500});
  backend().upload(large);
  image_of(backend(), view_of(large, 300));  // requests the sphere indices, which stay
  backend().upload(small);
  for (const uint width : {60u, 300u, 300u})
    drawing().draw(view_of(small, width), {.reuse_unchanged = false, .clusters_from = 0});
  backend().check_guards();
  const View view = view_of(small, 300);
  const Image given = image_of(backend(), view, {.clusters_from = 0});
  EXPECT_EQ(
      first_mismatch(given, image_of(backend(), view, {.frustum_culling = false, .occlusion_culling = false}), view),
      "");
}

// Images are enqueued, so that a device is free to draw one while it resolves the one before.
TEST_P(DrawTurns, MayOverlap) {
  const Scene scene = make_scene({.name = "uniform", .n = 3000});
  backend().upload(scene);
  std::vector<Shot> all;
  for (int k = 0; k < 12; ++k) {
    const uint width = 400 - 30 * (k % 5), height = 300 - 20 * (k % 3);
    Camera camera = frame(bounds_of(scene.positions), 30 * k, 20, 50, double(width) / height);
    const View view = make_view(camera, contact_look(), width, height);
    all.push_back({view, image_of(backend(), view, {.reuse_unchanged = false, .overlap = false})});
  }
  std::minstd_rand random(11);
  for (int turn = 0; turn < by_form(backend(), 40, 10); ++turn) {
    const Shot& shot = all[random() % all.size()];
    const bool overlap = random() % 8 > 0;
    for (uint before = random() % 20; before-- > 0;)
      drawing().enqueue_draw(all[random() % all.size()].view, {.reuse_unchanged = false, .overlap = overlap});
    const bool keep = random() % 4 == 0;
    drawing().draw(shot.view, {.reuse_unchanged = false, .keep_visible = keep});
    Image given{drawing().image(), shot.expected.visible};
    if (keep) given.visible = drawing().visible();
    ASSERT_EQ(first_mismatch(given, shot.expected, shot.view), "") << turn;
  }
  backend().check_guards();
}

// Spheres at the corners of their box, with cameras all around, so that the image's edge cuts through the nearest.
TEST_P(DrawTurns, TilesAreLeftOutWhereNoneCanBe) {
  Scene scene = make_scene({.name = "uniform", .n = 8, .radius = 0.5f});
  for (uint i = 0; i < 8; ++i)
    scene.positions[i] = {i & 1 ? 9.0f : 1.0f, i & 2 ? 9.0f : 1.0f, i & 4 ? 9.0f : 1.0f, 0.5f};
  backend().upload(scene);
  std::minstd_rand random(3);
  const auto number = [&](double low, double high) { return low + (high - low) * double(random()) / 2147483646.0; };
  const auto launches_of = [&](const View& view, bool ablation) {
    const uint64_t before = backend().work_counts().launches;
    drawing().draw(view, {.reuse_unchanged = false, .skip_tile_launches = ablation, .share_below = 0, .count = true});
    return backend().work_counts().launches - before;
  };
  launches_of(make_view({}, contact_look(), 203, 117), false);  // the first makes the pixels clear
  int left_out = 0, large = 0, close_call = 0;
  for (int k = 0; k < by_form(backend(), 400, 150); ++k) {
    Camera camera;
    const double away = number(4, 40);
    for (int a = 0; a < 3; ++a) camera.target[a] = number(-6, 16);
    for (int a = 0; a < 3; ++a) camera.eye[a] = 5 + number(-away, away);
    camera.field = number(30, 110);
    const View view = make_view(camera, contact_look(), 203, 117);
    const uint64_t all = launches_of(view, false);
    const DrawStatistics counts = drawing().draw_statistics();
    const bool skipped = launches_of(view, true) < all;
    EXPECT_FALSE(skipped && counts.large > 0) << k;
    left_out += skipped;
    large += counts.large > 0;
    uint widest = 0;
    for (const vec4& sphere : scene.positions) {
      const vec4 seen = in_camera(sphere, view);
      if (in_frustum(seen, view)) widest = std::max({widest, box_of(seen, view).width, box_of(seen, view).height});
    }
    close_call += skipped && widest >= WALK_AT_MOST - 4;
  }
  EXPECT_GT(left_out, 20);
  EXPECT_GT(large, 20);
  EXPECT_GT(close_call, 0) << "no image would show a bound that is a little too low";
  backend().move();
  View far = make_view({.eye = {5, 5, 100}, .target = {5, 5, 5}}, contact_look(), 203, 117);
  EXPECT_EQ(launches_of(far, true), launches_of(far, false)) << "spheres that have moved may be anywhere";
}

INSTANTIATE_BACKENDS(DrawTurns);

}  // namespace
}  // namespace spherepair
