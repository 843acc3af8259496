// SPDX-License-Identifier: MIT
// A window that exists in memory only.
#pragma once

#include <gtest/gtest.h>

#include "bench/formats/start.h"
#include "bench/viewer/window.h"

namespace spherepair {

// Shows nothing, and answers with the test's values.
class ScriptedWindow final : public Window, private WindowContext {
 public:
  bool next(Present) override { return true; }
  std::array<uint, 2> size() const override { return extent; }
  std::array<double, 2> dragged() const override { return drag; }
  std::array<double, 2> panned() const override { return pan; }
  double seconds() const override { return now += tick; }
  double scrolled() const override { return scroll; }
  bool pressed(char) const override { return false; }
  void begin_panel(const std::string& title) override {
    texts.clear();
    titles.push_back(title);
  }
  void end_panel() override {}
  void text(const std::string& line) override { texts += line + "\n"; }
  void legend(std::span<const uint> colours, const std::vector<std::string>& labels) override {
    EXPECT_EQ(colours.size(), labels.size());
    for (const std::string& label : labels) texts += label + "\n";
  }
  uint texture(uint, uint) override { return 0; }
  void upload(std::span<const uint> image) override {
    shown.assign(image.begin(), image.end());
    ++uploads;
  }
  void show() override {}
  std::vector<uint> screenshot() override { return shown; }
  WindowContext& context() override { return *this; }
  std::string renderer() const override { return "none"; }

  std::array<uint, 2> extent = {160, 120};
  std::array<double, 2> drag{}, pan{};
  mutable double now = 0;
  double tick = 0;  // seconds by which each reading advances the clock
  double scroll = 0;
  std::string texts;
  std::vector<std::string> titles;  // of all panels so far
  int uploads = 0;
  std::vector<uint> shown;

 private:
  void make_current() override {}
};

// What a viewer starts from: 200 random spheres.
inline Start start_of_200() {
  Start start;
  start.scene = make_scene({.name = "random", .n = 200});
  start.label = "random";
  return start;
}

}  // namespace spherepair
