// SPDX-License-Identifier: MIT
// What `spherepair view` shows while it moves and while it stands still, what it saves, its camera and its pace.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "bench/formats/png_file.h"
#include "bench/legend/legend.h"
#include "bench/viewer/viewer.h"
#include "common/image/canvas.h"
#include "tests/support/scripted_window.h"
#include "tests/support/sphere_files.h"

namespace spherepair {
namespace {

class ViewerImages : public testing::Test {
 protected:
  ViewerImages() { bounds_.low[1] = std::min(bounds_.low[1], double(start_.scene.plane)); }

  const std::vector<uint>& after(const std::string& keys, double seconds = 0) {
    for (const char key : keys) {
      window_.now += seconds;
      viewer_.frame(window_, key == '.' ? '\0' : key);
    }
    return window_.shown;
  }
  bool says(const std::string& text) const { return window_.texts.find(text) != std::string::npos; }

  // As `render --no-box` would draw step 0 from the viewer's first camera.
  std::vector<uint> rendered(uint samples, bool lit) {
    const auto backend = open_backend("cpu", {.threads = 1});
    backend->upload(start_.scene);
    backend->collide({.method = Method::collide_grid, .grid = {.cells = Cells::dense}});
    const auto [width, height] = window_.extent;
    ImageOptions image{frame(bounds_, 30, 20, 30, double(width) / height), contact_look(), width, height, samples};
    image.look.light = {-0.3, 0.9, -0.3};
    if (lit) image.look.lighting = LIGHT_OCCLUSION | LIGHT_SHADOW | LIGHT_GROUND;
    image.look.ground = double(start_.scene.plane);
    return draw_image(drawing_of(*backend), image).pixels;
  }

  const ScratchFolder folder_;
  const Start start_ = start_of_200();
  Bounds bounds_ = bounds_of(start_.scene.positions);
  const Session session_{{"cpu"}, {.threads = 1}};
  Viewer viewer_{
      session_, start_, {.backend = "cpu", .method = "collide_grid", .shared = false, .folder = folder_.path("")}};
  ScriptedWindow window_;
};

TEST_F(ViewerImages, WhatStandsStillBecomesTheImageOfRender) {
  EXPECT_EQ(after(" "), rendered(1, true));
  after("...............");
  EXPECT_EQ(window_.shown, rendered(1, true)) << "until all samples are there";
  EXPECT_EQ(window_.uploads, 1);
  EXPECT_EQ(after("."), rendered(16, true));
  after("......");
  EXPECT_EQ(window_.uploads, 2) << "nothing is left to draw";
  EXPECT_EQ(after("l"), rendered(1, false));
  EXPECT_EQ(after("................"), rendered(16, false));
  window_.drag = {9, 0};
  EXPECT_NE(after("."), rendered(1, false));
}

TEST_F(ViewerImages, SavedImagesReplaceNoFile) {
  window_.extent = {400, 200};
  after(" ");
  std::vector<uint> image = rendered(16, true);
  const auto cpu = open_backend("cpu", {.threads = 1});
  cpu->upload(start_.scene);
  cpu->collide({});
  const Legend legend =
      legend_of(contact_look(), {"200 spheres", fmt::format("{} pairs", cpu->collisions().pairs), "step 0"});
  const LegendStrip strip = LegendStrip::within(legend, 400, 200).value();
  strip.append_to(image, legend);
  const std::string expected = folder_.path("expected.png");
  write_png(expected, image, 400, 200 + strip.height());
  const std::string other = folder_.write("spherepair-0.png", "another file");
  std::filesystem::create_symlink("nowhere", folder_.path("spherepair-0-2.png"));
  after("s");
  EXPECT_TRUE(says("spherepair-0-3.png")) << window_.texts;
  EXPECT_EQ(read_bytes(folder_.path("spherepair-0-3.png")), read_bytes(expected));
  EXPECT_EQ(read_bytes(other), "another file");
  after("ns");
  EXPECT_TRUE(says("spherepair-1.png")) << window_.texts;
  EXPECT_EQ(folder_.names().size(), 5u);
}

TEST_F(ViewerImages, SavedImagesExplainColoursBySpeed) {
  window_.extent = {800, 300};
  after(" c");
  const std::vector<uint> plain = after("................");
  after("s");
  const std::string file = folder_.path("plain.png");
  write_png(file, plain, 800, 300);
  EXPECT_NE(read_bytes(folder_.path("spherepair-0.png")), read_bytes(file)) << "it has the legend";
}

TEST_F(ViewerImages, AnImageThatCannotBeSavedIsSaid) {
  Viewer viewer(session_, start_,
                {.backend = "cpu", .method = "collide_grid", .shared = false, .folder = folder_.path("missing")});
  EXPECT_TRUE(viewer.frame(window_, 's'));
  EXPECT_TRUE(says("cannot write")) << window_.texts;
  EXPECT_TRUE(viewer.frame(window_, '.'));
  EXPECT_EQ(folder_.names().size(), 0u);
}

class ViewerClock : public ViewerImages {
 protected:
  const std::vector<uint>& after(const std::string& keys, double seconds = 0) {
    for (const char key : keys) {
      window_.now += seconds;
      clocked_.frame(window_, key == '.' ? '\0' : key);
    }
    return window_.shown;
  }
  uint64_t step() const { return std::stoull(window_.titles.back().substr(std::string("spherepair, step ").size())); }

  Viewer clocked_{session_, start_, {.backend = "cpu", .method = "collide_grid", .shared = false, .speed = 1}};
};

// Its first frame takes no step. A step is a 64th of a second.
TEST_F(ViewerClock, StepsFollowTheClock) {
  after("...", 0.25);
  EXPECT_EQ(step(), 32u);
  after("..", 1.0 / 256);
  EXPECT_EQ(step(), 32u);
  after("..", 1.0 / 256);
  EXPECT_EQ(step(), 33u);
  after("+.", 0.25);
  EXPECT_EQ(step(), 65u) << "twice the speed, from the key on";
  EXPECT_TRUE(says("speed 2 (+")) << window_.texts;
  after("--.", 0.25);
  EXPECT_EQ(step(), 73u);
  EXPECT_TRUE(says("speed 0.5 (+")) << window_.texts;
  after(" ... .", 5);
  EXPECT_EQ(step(), 73u + 160u) << "no time passes in a pause";
}

TEST_F(ViewerClock, FallsBehindWhereStepsTakeTooLong) {
  window_.tick = 0.125;
  after("..........", 0.125);
  EXPECT_EQ(step(), 9u) << "and no more steps from frame to frame";
  window_.tick = 0;
  after(".", 0.25);
  EXPECT_LE(step(), 10u + 16u + 16u) << "what was missed is not made up for";
}

// Where a point appears, pixels.
Point seen_at(const Vector& point, const View& v) {
  const double x = point[0] - v.eye.x, y = point[1] - v.eye.y, z = point[2] - v.eye.z;
  const auto along = [&](const vec4& axis) { return x * axis.x + y * axis.y + z * axis.z; };
  return {v.centre_x + along(v.right) / along(v.forward) * v.focal,
          v.centre_y - along(v.up) / along(v.forward) * v.focal};
}

TEST(ViewerCamera, WhatIsPannedFollowsTheMouse) {
  Orbit orbit({{-1, 0, 2}, {3, 5, 4}});
  orbit.turn({70, -20});
  orbit.zoom(3);
  const auto view_of = [&] { return make_view(orbit.camera(1.5), contact_look(), 300, 200); };
  const Vector target = orbit.camera(1.5).target;
  orbit.pan({24, -10}, view_of());
  EXPECT_NEAR(seen_at(target, view_of()).x, 149.5 + 24, 1e-3);
  EXPECT_NEAR(seen_at(target, view_of()).y, 99.5 - 10, 1e-3);
  orbit.reset();
  EXPECT_EQ(orbit.camera(1.5).eye, frame({{-1, 0, 2}, {3, 5, 4}}, 30, 20, 30, 1.5).eye);
}

}  // namespace
}  // namespace spherepair
