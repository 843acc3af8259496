// SPDX-License-Identifier: MIT
// What `spherepair view` does with its user's input, in a window that exists in memory only.
#include <gtest/gtest.h>

#include <algorithm>

#include "bench/viewer/viewer.h"
#include "tests/support/scripted_window.h"

namespace spherepair {
namespace {

class ViewerInput : public testing::Test {
 protected:
  std::vector<uint> after(const std::string& keys) {
    for (const char key : keys) viewer_.frame(window_, key == '.' ? '\0' : key);
    return window_.shown;
  }
  bool says(const std::string& text) const { return window_.texts.find(text) != std::string::npos; }

  const Start start_ = start_of_200();
  const Session session_{{"cpu"}, {.threads = 1}};
  Viewer viewer_{session_, start_, {.backend = "cpu", .method = "collide_grid", .shared = false}};
  ScriptedWindow window_;
};

TEST_F(ViewerInput, SingleStepsAndRestartsShowTheSameImages) {
  const std::vector<uint> fifth = after("....."), sixth = after(".");
  EXPECT_NE(fifth, sixth);
  const std::vector<uint> start = after(" r.....");
  EXPECT_EQ(after("."), start) << "it is paused";
  EXPECT_EQ(after("nnnnn"), fifth);
  EXPECT_EQ(after("n"), sixth);
  EXPECT_EQ(window_.titles.back(), "spherepair, step 6");
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
  EXPECT_TRUE(says("contacts (c):\n0\n1\n2\n")) << window_.texts;
  EXPECT_FALSE(has_violet_or_green(contacts));
  after(" ..........");
  const std::vector<uint> speed = after(" c.");
  EXPECT_TRUE(says("speed in m/s, at least (c):\n< ")) << window_.texts;
  EXPECT_TRUE(has_violet_or_green(speed));
  const std::vector<uint> radius = after("c.");
  EXPECT_NE(radius, speed);
  EXPECT_TRUE(says("radius in m, at least (c):\n< ")) << window_.texts;
  const std::vector<uint> back = after("c.");
  EXPECT_TRUE(says("contacts (c):\n0\n1\n2\n")) << window_.texts;
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

TEST_F(ViewerInput, ThePanelHides) {
  after("..");
  EXPECT_EQ(window_.titles.back(), "spherepair, step 2");
  EXPECT_TRUE(says("cpu (b)")) << window_.texts;
  after("h.");
  EXPECT_EQ(window_.titles.size(), 2u) << "hidden";
  after("h");
  EXPECT_EQ(window_.titles.back(), "spherepair, step 5");
}

TEST_F(ViewerInput, QAndEscapeClose) {
  for (const char key : std::string("q\x1b")) EXPECT_FALSE(viewer_.frame(window_, key));
  for (const char key : std::string("\0abcdhlmnrs +-", 14)) EXPECT_TRUE(viewer_.frame(window_, key)) << key;
}

}  // namespace
}  // namespace spherepair
