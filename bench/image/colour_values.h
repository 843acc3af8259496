// SPDX-License-Identifier: MIT
// The numbers by which spheres of a backend or a file are coloured.
#pragma once

#include "bench/formats/start.h"
#include "common/image/colouring.h"

namespace spherepair {

// The value of each sphere that decides its colour (colouring.h). Radii are in the start's unit of length; a species is
// its index in Start::species.
std::vector<double> values_of(ColourBy by, const Start& start, Search& search, const Motion::State& state);

// The range of speeds for a video's colours: from 0 to the 98 % quantile; the fastest 2 % share the last colour.
std::vector<double> range_of_speeds(std::vector<double> speeds);

// values: an image's or all images'; with `clipped`, both ends of a range. Several starts are the frames of a file,
// which share their colours.
Colouring colouring_of(ColourBy by, const std::vector<Start>& starts, std::vector<double> values, bool clipped);

}  // namespace spherepair
