// SPDX-License-Identifier: MIT
// What `spherepair view` does with its user's input, in a window that exists in memory only; and its history.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "bench/check/step_result.h"
#include "bench/viewer/history.h"
#include "bench/viewer/viewer.h"
#include "common/scene/counted.h"
#include "tests/support/scripted_window.h"

namespace spherepair {
namespace {

Start start_at(uint64_t step, MotionMethod method) {
  Start start;
  start.scene = make_scene({.name = "random", .n = 200});
  start.scene.motion.method = method;
  start.label = "random";
  start.step = step;
  return start;
}

uint64_t hash_of(Backend& backend) {
  const Motion::State state = current_state(backend);
  return state_hash(state.positions, state.velocities, state.wide);
}

TEST(History, GoesBackToTheSameBits) {
  for (const MotionMethod method : {MotionMethod::paper, MotionMethod::anchored}) {
    const Start start = start_at(5, method);
    const auto backend = open_backend("cpu", {.threads = 1});
    History history(start);
    history.go_to(*backend, 5);
    std::map<uint64_t, uint64_t> hashes = {{5, hash_of(*backend)}};
    for (uint64_t step = 6; step <= 205; ++step) {
      backend->move();
      history.record(*backend, step);
      hashes[step] = hash_of(*backend);
    }
    EXPECT_EQ(history.last(), 205u);
    EXPECT_GT(history.states(), 3u);
    for (const uint64_t step : {5u, 6u, 36u, 37u, 101u, 205u, 69u}) {
      history.go_to(*backend, step);
      EXPECT_EQ(hash_of(*backend), hashes.at(step)) << "step " << step;
    }
  }
}

TEST(History, KeepsNoMoreThanItMay) {
  const Start start = start_at(0, MotionMethod::paper);
  const auto backend = open_backend("cpu", {.threads = 1});
  const uint64_t bytes = start.scene.size() * 2 * sizeof(vec4);
  for (const uint64_t most : {uint64_t(0), uint64_t(1), uint64_t(5), uint64_t(1000)}) {
    History history(start, most * bytes);
    history.go_to(*backend, 0);
    for (uint64_t step = 1; step <= 5000; ++step) {
      backend->move();
      history.record(*backend, step);
      ASSERT_LE(history.states(), std::min<uint64_t>(most, 64)) << "step " << step;
    }
    const uint64_t last = hash_of(*backend);
    history.go_to(*backend, 4321);
    EXPECT_NE(hash_of(*backend), last);
    history.go_to(*backend, 5000);
    EXPECT_EQ(hash_of(*backend), last) << most << " states";
  }
}

class ViewerInput : public testing::Test {
 protected:
  std::vector<uint> after(const std::string& keys) {
    for (const char key : keys) viewer_.frame(window_, key == '.' ? '\0' : key);
    return window_.shown;
  }
  bool says(const std::string& text) const { return window_.texts.find(text) != std::string::npos; }

  const Start start_ = start_at(0, MotionMethod::paper);
  const Session session_{{"cpu"}, {.threads = 1}};
  Viewer viewer_{session_, start_, {.backend = "cpu", .method = "collide_grid", .shared = false}};
  ScriptedWindow window_;
};

TEST_F(ViewerInput, StepsBackAndForthShowTheSameImages) {
  const std::vector<uint> fifth = after("....."), sixth = after(".");
  EXPECT_NE(fifth, sixth);
  EXPECT_EQ(after("z"), fifth);
  EXPECT_EQ(after("."), fifth) << "it is paused";
  EXPECT_EQ(after("n"), sixth);
  after(" ....");
  EXPECT_TRUE(says("step 11:")) << window_.texts;
  window_.slid = 5;
  after(".");
  EXPECT_EQ(after("."), fifth);
  EXPECT_EQ(window_.range, (std::array<uint64_t, 2>{0, 12}));
}

TEST_F(ViewerInput, AClickTellsTheSphereOfThatPixel) {
  after(" .");
  const auto backend = open_backend("cpu", {.threads = 1});
  backend->upload(start_.scene);
  backend->collide({});
  const std::vector<uint> contacts = backend->counts();
  std::set<size_t> found;
  for (uint y = 0; y < 120; y += 8)
    for (uint x = 0; x < 160; x += 8) {
      window_.click = {{x, y}};
      after(".");
      const bool background = window_.shown[y * 160 + x] == ~0u;
      EXPECT_FALSE(background && says("\ncentre")) << x << ", " << y;
      if (!says("\ncentre")) continue;
      const size_t sphere = std::stoul(window_.texts.substr(window_.texts.find("\nsphere ") + 8));
      EXPECT_TRUE(says(fmt::format("sphere {} at step 0: {}\n", sphere, counted(contacts.at(sphere), "contact"))))
          << window_.texts;
      found.insert(sphere);
    }
  EXPECT_GT(found.size(), 20u);
  window_.click = {{159, 0}};
  after(".");
  EXPECT_FALSE(says("\ncentre")) << window_.texts;
}

// The hues of lit spheres: a colour is told by the order of its channels.
bool has_violet_or_green(const std::vector<uint>& image) {
  return std::ranges::any_of(image, [](uint pixel) {
    const uint red = pixel & 255, green = pixel >> 8 & 255, blue = pixel >> 16 & 255;
    return (green > red + 20 && green > blue + 20) || (blue > green + 40 && red > green + 20);
  });
}

TEST_F(ViewerInput, ColoursFollowContactsSpeedOrRadius) {
  const std::vector<uint> contacts = after(" l.");
  EXPECT_TRUE(says("contacts:\n0\n1\n2\n")) << window_.texts;
  EXPECT_FALSE(has_violet_or_green(contacts));
  after(" ..........");
  const std::vector<uint> speed = after(" c.");
  EXPECT_TRUE(says("speed in m/s, at least:\n< ")) << window_.texts;
  EXPECT_TRUE(has_violet_or_green(speed));
  const std::vector<uint> radius = after("c.");
  EXPECT_NE(radius, speed);
  EXPECT_TRUE(says("radius in m, at least:\n< ")) << window_.texts;
  const std::vector<uint> back = after("cz");
  EXPECT_TRUE(says("contacts:\n0\n1\n2\n")) << window_.texts;
  EXPECT_FALSE(has_violet_or_green(back));
  EXPECT_EQ(after("."), back) << "it is paused";
}

TEST_F(ViewerInput, TheMouseTurnsPansAndZooms) {
  const std::vector<uint> before = after(" .");
  EXPECT_EQ(after("."), before);
  window_.drag = {30, 10};
  const std::vector<uint> turned = after(".");
  EXPECT_NE(turned, before);
  window_.drag = {};
  EXPECT_EQ(after("."), turned);
  window_.pan = {0, 20};
  const std::vector<uint> panned = after(".");
  EXPECT_NE(panned, turned);
  window_.pan = {};
  EXPECT_EQ(after("."), panned);
  window_.scroll = 2;
  EXPECT_NE(after("."), panned);
  window_.scroll = 0;
  window_.drag = {-30, -10};
  EXPECT_NE(after("."), before);
  window_.drag = {};
  EXPECT_EQ(after("a"), before) << "all in view";
}

TEST_F(ViewerInput, ThePanelFoldsAndHides) {
  after("..");
  EXPECT_EQ(window_.titles.back(), "spherepair, step 2");
  EXPECT_TRUE(says("step 2:")) << window_.texts;
  after("p");
  EXPECT_TRUE(window_.folded);
  EXPECT_EQ(window_.texts, "");
  after("h.");
  EXPECT_EQ(window_.titles.size(), 3u) << "hidden";
  after("h");
  EXPECT_EQ(window_.titles.back(), "spherepair, step 6");
  EXPECT_TRUE(window_.folded);
  window_.folds = false;  // by its arrow
  after("..");
  EXPECT_FALSE(window_.folded);
  EXPECT_TRUE(says("step 8:")) << window_.texts;
}

TEST_F(ViewerInput, QAndEscapeClose) {
  for (const char key : std::string("q\x1b")) EXPECT_FALSE(viewer_.frame(window_, key));
  for (const char key : std::string("\0abcdefhlmnprsz +-", 18)) EXPECT_TRUE(viewer_.frame(window_, key)) << key;
}

}  // namespace
}  // namespace spherepair
