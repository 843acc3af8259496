// SPDX-License-Identifier: MIT
// How spheres move: the method, and the precision of the state that it keeps.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/shared/layout.h"

namespace spherepair {

enum class MotionMethod : uint {
  euler,          // explicit Euler; turned round where a step ends below the plane
  symplectic,     // semi-implicit Euler; the same turn
  paper,          // the paper's equation 1 and code 1: exact between bounces; the same turn
  paper_clamp,    // paper, and what is below the plane even so is put on it
  impact_linear,  // time of impact on a straight path, one bounce a step
  impact,         // quadratic time of impact, any number of bounces a step
  anchored,       // the last bounce and the steps since: nothing is rounded between bounces
  leapfrog,       // with contacts alone: impulses, then positions, in integers; always `fixed`
};

// Of positions and velocities from step to step; collisions are always those of the nearest float32 numbers.
// compensated: the sum of two float32; fixed: 64-bit integers.
enum class Precision : uint { float32, compensated, float64, fixed };

struct MotionOptions {
  MotionMethod method = MotionMethod::paper;
  Precision precision = Precision::float32;
  auto operator<=>(const MotionOptions&) const = default;
};

const std::vector<MotionOptions>& all_motions();  // without contacts: every method in every precision

const char* motion_name(MotionMethod method);  // euler, ... paper-clamp, ...
const char* precision_name(Precision precision);
std::string motion_label(MotionOptions motion);  // paper float32

// Of motions without contacts. Throw std::invalid_argument with the known names.
MotionMethod motion_from_name(const std::string& name);
Precision precision_from_name(const std::string& name);

}  // namespace spherepair
