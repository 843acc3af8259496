// SPDX-License-Identifier: MIT
// How long the longest batch of a sample lasts on a GPU at least, in seconds.
#pragma once

namespace spherepair {

// The fixed cost of a sample, fitted, is 6 us in CUDA and 60 us in OpenGL, in nine of ten below 15 and 120: 0.5 % of 24 ms.
constexpr double device_batch_seconds = 0.03;
// Where a batch begins with planning or changes what it finds: up to 300 us.
constexpr double restarted_batch_seconds = 0.06;

}  // namespace spherepair
