// SPDX-License-Identifier: MIT
// How spheres move: the method, and the precision of its state.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/shared/layout.h"

namespace spherepair {

enum class MotionMethod : uint {
  euler,          // explicit Euler; a step that ends below the plane is redone with v reversed
  symplectic,     // semi-implicit Euler; redone likewise
  paper,          // the paper's equation 1 and code 1: exact between bounces; redone likewise
  paper_clamp,    // paper, then spheres still below the plane are put on it
  impact_linear,  // time of impact on a straight path, one bounce a step
  impact,         // quadratic time of impact, any number of bounces a step
  anchored,       // the last bounce and the steps since: nothing is rounded between bounces
  leapfrog,       // only with contacts: impulses, then positions, in integers; always `fixed`
};

// The precision of positions and velocities between steps; collisions always use the nearest float32 numbers.
// compensated: the sum of two float32; fixed: 64-bit integers.
enum class Precision : uint { float32, compensated, float64, fixed };

struct MotionOptions {
  MotionMethod method = MotionMethod::paper;
  Precision precision = Precision::float32;
  auto operator<=>(const MotionOptions&) const = default;
};

const std::vector<MotionOptions>& all_motions();  // without contacts: every method with every precision

const char* motion_name(MotionMethod method);  // euler, ... paper-clamp, ...
const char* precision_name(Precision precision);
std::string motion_label(MotionOptions motion);  // paper float32

// For motions without contacts. Both throw std::invalid_argument with the known names.
MotionMethod motion_from_name(const std::string& name);
Precision precision_from_name(const std::string& name);

}  // namespace spherepair
