// SPDX-License-Identifier: MIT
// What drawing leaves out: with each skip on or off, in images one after the other, not a bit differs from drawing
// all.
#include <fmt/format.h>

#include <cmath>

#include "tests/oracle/oracle.h"
#include "tests/support/images.h"

namespace spherepair {
namespace {

constexpr uint width = 203, height = 117;

class DrawCulling : public DeviceImages {};

const DrawOptions everything = {
    .frustum_culling = false, .occlusion_culling = false, .reuse_unchanged = false, .skip_tile_launches = false};

// Of all_culling().
enum : size_t { outside_only, hidden_only, both, deferring, bundled };

std::vector<DrawOptions> all_culling() {
  std::vector<DrawOptions> all;
  for (const auto& [outside, hidden] : {std::pair{true, false}, {false, true}, {true, true}}) {
    DrawOptions options = {.frustum_culling = outside, .occlusion_culling = hidden, .reuse_unchanged = false};
    options.clusters_from = options.cull_from = 0;
    options.count = true;
    all.push_back(options);
  }
  all.push_back(all.back());
  all.back().defer_from = 0;
  for (const uint64_t defer_from : {uint64_t(0), ~uint64_t(0)}) {
    all.push_back(all[deferring]);
    all.back().defer_from = defer_from;
    all.back().bundles_from = 0;
  }
  all.push_back({.frustum_culling = false, .occlusion_culling = false, .reuse_unchanged = false, .share_below = 0});
  all.push_back({.reuse_unchanged = false, .clusters_from = 0});  // clusters are not tested
  return all;
}

// Round the spheres, then through them.
View view_of(const Scene& scene, int step) {
  Camera camera = frame(bounds_of(scene.positions), 30 + 20 * step, 20, 60, double(width) / height);
  const double nearer = step < 2 ? 1 : 0.25 * (4 - step);
  for (int a = 0; a < 3; ++a) camera.eye[a] = camera.target[a] + (camera.eye[a] - camera.target[a]) * nearer;
  if (step == 4) camera.target[0] += 1;
  return make_view(camera, contact_look(), width, height);
}

TEST_P(DrawCulling, NoImageChanges) {
  for (const char* kind : {"uniform", "clustered"}) {
    const float ratio = kind[0] == 'c' ? 20 : 1;
    const uint64_t n = by_form(backend(), 5000, 2000);
    const Scene scene = make_scene({.name = kind, .n = n, .radius = 0.5f / ratio, .radius_ratio = ratio});
    backend().upload(scene);
    backend().collide({.method = Method::collide_grid});
    for (const int step : kind[0] == 'c' ? std::vector{3} : std::vector{0, 4}) {
      const View view = view_of(scene, step);
      const Image expected = image_of(backend(), view, everything);
      for (const DrawOptions& options : all_culling())
        EXPECT_EQ(first_mismatch(image_of(backend(), view, options), expected, view), "")
            << kind << ", ratio " << ratio << ", step " << step << ", outside " << options.frustum_culling
            << ", hidden " << options.occlusion_culling << ", deferred from " << options.defer_from << ", bundles from "
            << options.bundles_from;
    }
  }
}

// Spheres move while the camera does; those in no cell order form poor clusters, but clusters.
TEST_P(DrawCulling, WhileSpheresMove) {
  const Scene scene = make_scene({.n = by_form(backend(), 5000u, 2000u)});
  for (const size_t ablation : {both, deferring, bundled})
    for (const bool collide : {false, true}) {
      backend().upload(scene);
      for (int step = 0; step < 4; ++step) {
        backend().move();
        if (collide) backend().collide({.method = Method::collide_grid});
        const View view = view_of(scene, step);
        const Image given = image_of(backend(), view, all_culling()[ablation]);
        EXPECT_EQ(first_mismatch(given, image_of(backend(), view, everything), view), "")
            << step << ", " << collide << ", skip " << ablation;
      }
    }
}

// Rows so long that most clusters are in one of them and are held by the borders of its cells; the camera goes along
// them, so that its image's edges cut through clusters.
TEST_P(DrawCulling, WhileLongRowsMove) {
  constexpr uint along = 200, across = 9;
  Scene scene = make_scene({.name = "uniform", .n = along * across * across, .radius = 0.5f});
  for (uint i = 0; i < scene.size(); ++i) {
    const uint x = i % along, y = i / along % across, z = i / along / across;
    scene.positions[i] = {float(x) * 1.1f, 2 + float(y) * 1.1f, float(z) * 1.1f, 0.5f};
  }
  backend().upload(scene);
  for (int step = 0; step < 6; ++step) {
    backend().move();
    backend().collide({.method = Method::collide_grid, .grid = {.cells = Cells::dense}});
    Camera camera = frame(bounds_of(scene.positions), 20, 10, 50, double(width) / height);
    camera.target[0] = 20 + 35 * step, camera.target[1] = camera.target[2] = 5;
    camera.eye[0] = camera.target[0] + 4, camera.eye[1] = 12, camera.eye[2] = 20;
    const View view = make_view(camera, contact_look(), width, height);
    const Image expected = image_of(backend(), view, everything);
    for (const size_t ablation : {outside_only, both, bundled})
      EXPECT_EQ(first_mismatch(image_of(backend(), view, all_culling()[ablation]), expected, view), "")
          << step << ", " << ablation;
  }
}

// Images bring contacts along from the cell order; a step in another order, after a move, starts from none.
TEST_P(DrawCulling, ContactsOfAnImageDoNotStay) {
  const Scene scene = make_scene({.n = 3000});
  backend().upload(scene);
  for (int step = 0; step < 3; ++step) {
    backend().move();
    backend().collide({.method = Method::collide_grid});
    image_of(backend(), view_of(scene, 0), all_culling()[both]);
  }
  backend().move();
  std::vector<uint> expected(scene.size());
  for (const Pair& pair : swept_pairs(current_state(backend()).positions))
    ++expected[pair.first], ++expected[pair.second];
  for (const Method method : {Method::collide_triangle, Method::collide_grid}) {
    backend().collide({.method = method});
    EXPECT_EQ(backend().counts(), expected) << method_name(method);
  }
}

// A wall of spheres hides what is behind it, but for what shows through a hole. The third image from one position
// draws first only what the second one found not hidden, the first one from there what was hidden until then.
TEST_P(DrawCulling, ThroughAHole) {
  std::vector<vec4> spheres;
  for (int k = 0; k < 40 * 64; ++k) spheres.push_back({float(k % 64) * 0.5f - 16, float(k / 64) * 0.5f - 10, 0, 0.5f});
  std::erase_if(spheres, [](const vec4& s) { return std::abs(s.x) < 0.9f && std::abs(s.y) < 0.9f; });
  const size_t whole = CLUSTER * BUNDLE;  // so that what shows through the hole is the last cluster of its bundle
  spheres.resize((spheres.size() + whole - 1) / whole * whole, vec4{-15, -9, 0, 0.5f});
  for (int k = 0; k < 30 * CLUSTER; ++k)  // clusters in columns, one of them behind the hole
    spheres.push_back(
        {float(k / CLUSTER - 15) * 0.6f, float(k % 8) * 0.1f - 0.4f, -12 - float(k % 64 / 8) * 0.1f, 0.1f});
  const Scene scene = scene_of(spheres);
  const View front = make_view({{0, 0, 20}, {0, 0, 0}}, contact_look(), width, height);
  const View overlapped =
      make_view({{9, 0, 20}, {0, 0, 0}}, contact_look(), width, height);  // another shows from there
  backend().upload(scene);
  std::vector<std::pair<View, Image>> images;
  for (const View& view : {overlapped, overlapped, front, front, front})
    images.emplace_back(view, image_of(backend(), view, everything));
  for (const size_t ablation : {1, 3, 4, 5}) {
    backend().upload(scene);  // nothing was seen of it
    for (const auto& [view, expected] : images)
      EXPECT_EQ(first_mismatch(image_of(backend(), view, all_culling()[ablation]), expected, view), "")
          << "skip " << ablation << ", from " << view.eye.x;
    const DrawStatistics counts = drawing().draw_statistics();
    EXPECT_GT(counts.clusters_hidden, 10u) << "skip " << ablation;
    EXPECT_EQ(counts.bundles_left_out > 2, ablation > 3) << "skip " << ablation;
    EXPECT_EQ(counts.clusters_deferred > 10, ablation == 4)
        << "bundles that were hidden are deferred untested: skip " << ablation;
  }
}

// Longer than a sphere that is not seen again stands in the list of those seen, there and back.
TEST_P(DrawCulling, OverManyImages) {
  const Scene scene = make_scene({.name = "uniform", .n = by_form(backend(), 8000u, 2000u)});
  backend().upload(scene);
  backend().collide({.method = Method::collide_grid});
  for (const size_t ablation : {2, 3, 4, 5}) {  // the far ones at once, deferred, by bundles
    uint64_t hidden = 0;
    for (int image = 0; image < 19; ++image) {
      const double azimuth = image < 17 ? 2 * image : 0;
      const Camera camera = frame(bounds_of(scene.positions), azimuth, 10, 40, double(width) / height);
      const View view = make_view(camera, contact_look(), width, height);
      const Image given = image_of(backend(), view, all_culling()[ablation]);
      hidden += drawing().draw_statistics().hidden;
      EXPECT_EQ(first_mismatch(given, image_of(backend(), view, everything), view), "")
          << image << ", skip " << ablation;
    }
    EXPECT_GT(hidden, scene.size()) << "of 18 times as many, skip " << ablation;
  }
}

// Each skip is used: without that, its test would prove nothing.
TEST_P(DrawCulling, AreCounted) {
  const Scene scene = make_scene({.name = "uniform", .n = 60000});
  backend().upload(scene);
  backend().collide({.method = Method::collide_grid});
  const DrawOptions outside = all_culling()[outside_only], hidden = all_culling()[hidden_only];
  drawing().draw(view_of(scene, 4), outside);
  DrawStatistics counts = drawing().draw_statistics();
  EXPECT_EQ(counts.clusters, (scene.size() + CLUSTER - 1) / CLUSTER);
  EXPECT_GT(counts.clusters_outside, counts.clusters / 4);
  EXPECT_EQ(counts.clusters_hidden, 0u);
  // Clusters are rows along x: a view along z sees no ends of rows. The second image still draws all.
  const Camera front = frame(bounds_of(scene.positions), 0, 0, 40, double(width) / height);
  for (int time = 0; time < 3; ++time) drawing().draw(make_view(front, contact_look(), width, height), hidden);
  counts = drawing().draw_statistics();
  EXPECT_GT(counts.clusters_hidden, counts.clusters / 4);
  EXPECT_LT(counts.drawn + counts.unseen, scene.size() * 3 / 4);
  EXPECT_EQ(counts.clusters_deferred, 0u);
  drawing().draw(make_view(front, contact_look(), width, height), all_culling()[deferring]);
  const DrawStatistics after = drawing().draw_statistics();
  EXPECT_GT(after.clusters_deferred, 0u);
  EXPECT_GT(after.clusters_hidden, counts.clusters / 4) << "the deferred clusters are hidden in the end";
  EXPECT_EQ(after.bundles_left_out, 0u);
  drawing().draw(make_view(front, contact_look(), width, height), all_culling()[bundled]);
  const DrawStatistics in_bundles = drawing().draw_statistics();
  EXPECT_GT(in_bundles.bundles_left_out, counts.clusters / BUNDLE / 8);
  EXPECT_GT(in_bundles.clusters_hidden, counts.clusters / 4);
}

TEST_P(DrawCulling, AnUnchangedImageIsKept) {
  const Scene scene = make_scene({.n = 1000});
  const View view = view_of(scene, 0);
  backend().upload(scene);
  const auto kept_after = [&](const View& at) {
    drawing().draw(at, {.count = true});
    return drawing().draw_statistics().images_kept;
  };
  EXPECT_EQ(kept_after(view), 0u);
  EXPECT_EQ(kept_after(view), 1u);
  EXPECT_EQ(kept_after(view_of(scene, 1)), 1u);
  backend().move();
  EXPECT_EQ(kept_after(view_of(scene, 1)), 1u);
  EXPECT_EQ(kept_after(view_of(scene, 1)), 2u);
  backend().collide({.method = Method::collide_grid});
  EXPECT_EQ(kept_after(view_of(scene, 1)), 2u);
}

INSTANTIATE_BACKENDS(DrawCulling);

}  // namespace
}  // namespace spherepair
