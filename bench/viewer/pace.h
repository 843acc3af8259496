// SPDX-License-Identifier: MIT
// Chooses the number of steps in a frame, so that a watched run keeps up with the clock.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace spherepair {

class Pace {
 public:
  static constexpr double slowest = 0x1p-20, fastest = 0x1p20;  // speeds by the clock

  // dt: seconds a step; speed: seconds of the scene in a second of the clock; 0: one step a frame.
  Pace(double dt, double speed) : dt_(dt), speed_(speed > 0 ? speed : 1), by_clock_(speed > 0) {}

  bool by_clock() const { return by_clock_; }
  double speed() const { return speed_; }
  void toggle_clock();        // by the clock, or one step a frame
  void scale(double factor);  // the speed, within its limits, by the clock

  // The steps of a frame that begins at `now`, seconds. Steps that took() does not report are dropped: a run that
  // cannot keep up falls behind the clock.
  uint64_t due(double now);
  void took(uint64_t steps);  // steps taken in the frame of the last due()
  void hold();                // no time passes until the next frame
  std::string text() const;   // the speed, and the reached speed if it differs

 private:
  double dt_, speed_;
  bool by_clock_;
  double owed_ = 0;                     // steps
  std::optional<double> last_, since_;  // the last frame; the start of the measurement of speed
  uint64_t steps_ = 0;                  // since since_
  std::optional<double> reached_;
};

}  // namespace spherepair
