// SPDX-License-Identifier: MIT
// The numbers by which spheres are coloured, of a backend's spheres or of a file's.
#pragma once

#include "bench/formats/start.h"
#include "bench/image/colouring.h"

namespace spherepair {

// Of the spheres that the backend has: contacts of the last collide(), metres, metres a second, or indices into
// Start::species.
std::vector<double> values_of(ColourBy by, const Start& start, Backend& backend, const Backend::State& state);

// Speeds for a video's colours: equal intervals from 0 to all but the fastest 2 %, which share the last colour.
std::vector<double> range_of_speeds(std::vector<double> speeds);

// values: of an image or of all; or, `clipped`, both ends of a range. More starts than one are the frames of a file,
// which share their colours.
Colouring colouring_of(ColourBy by, const std::vector<Start>& starts, std::vector<double> values, bool clipped);

}  // namespace spherepair
