// SPDX-License-Identifier: MIT
#include "bench/viewer/pace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace spherepair {

void Pace::toggle_clock() {
  by_clock_ = !by_clock_;
  hold();
}

void Pace::scale(double factor) {
  speed_ = std::clamp(speed_ * factor, slowest, fastest);
  by_clock_ = true;
  hold();
}

void Pace::hold() {
  last_.reset();
  since_.reset();
  reached_.reset();
  owed_ = 0;
  steps_ = 0;
}

uint64_t Pace::due(double now) {
  if (last_) owed_ = owed_ - std::floor(owed_) + (now - *last_) * speed_ / dt_;
  last_ = now;
  if (!since_) since_ = now;
  return by_clock_ ? uint64_t(std::min(owed_, 0x1p53)) : 1;
}

// Measures the speed over half a second, so that the number is readable. The first frame's steps belong to the time
// before.
void Pace::took(uint64_t steps) {
  if (!last_) return;  // a single step in a pause
  const double seconds = *last_ - *since_;
  if (seconds > 0) steps_ += steps;
  if (seconds < 0.5) return;
  reached_ = double(steps_) * dt_ / seconds;
  since_ = last_;
  steps_ = 0;
}

std::string Pace::text() const {
  const std::string reached = reached_ ? fmt::format("{:.2g}", *reached_) : "";
  if (!by_clock_) return "one step a frame" + (reached_ ? fmt::format(": speed {}", reached) : "");
  const bool behind = reached_ && *reached_ < 0.9 * speed_;
  return fmt::format("speed {:.3g}{}", speed_, behind ? fmt::format(", reached {}", reached) : "");
}

}  // namespace spherepair
