// SPDX-License-Identifier: MIT
// A window that exists in memory only.
#pragma once

#include <gtest/gtest.h>

#include <utility>

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
  std::optional<std::array<uint, 2>> clicked() const override { return click; }
  bool pressed(char) const override { return false; }
  void begin_panel(const std::string& title, bool& folded) override {
    texts.clear();
    titles.push_back(title);
    if (folds) folded = *std::exchange(folds, {});
    this->folded = folded;
  }
  void end_panel() override {}
  void text(const std::string& line) override { texts += line + "\n"; }
  void same_row() override {}
  bool button(const char*) override { return false; }
  void check(const char*, bool&) override {}
  void slide(const char*, uint64_t& value, uint64_t low, uint64_t high) override {
    range = {low, high};
    if (slid) value = *std::exchange(slid, {});
  }
  void choose(const char*, const std::vector<std::string>&, size_t&) override {}
  void legend(std::span<const uint> colours, const std::vector<std::string>& labels) override {
    EXPECT_EQ(colours.size(), labels.size());
    for (const std::string& label : labels) texts += label + "\n";
  }
  uint texture(uint, uint) override { return 0; }
  void upload(std::span<const uint> image) override {
    shown.assign(image.begin(), image.end());
    ++uploads;
  }
  void line(Point, Point, double, uint, double opacity) override { next_lines.push_back(opacity); }
  void show() override { lines = std::exchange(next_lines, {}); }
  std::vector<uint> screenshot() override { return shown; }
  WindowContext& context() override { return *this; }
  std::string renderer() const override { return "none"; }

  std::array<uint, 2> extent = {160, 120};
  std::array<double, 2> drag{}, pan{};
  mutable double now = 0;
  double tick = 0;  // seconds by which each reading advances the clock
  double scroll = 0;
  std::optional<std::array<uint, 2>> click;
  std::optional<uint64_t> slid;
  std::array<uint64_t, 2> range{};
  std::string texts;
  std::vector<std::string> titles;  // of all panels so far
  std::optional<bool> folds;        // set by the user
  bool folded = false;
  std::vector<double> lines, next_lines;  // opacities
  int uploads = 0;
  std::vector<uint> shown;

 private:
  void make_current() override {}
};

}  // namespace spherepair
