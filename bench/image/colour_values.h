// SPDX-License-Identifier: MIT
// The numbers by which spheres are coloured, of a backend's spheres or of a file's.
#pragma once

#include "bench/formats/start.h"
#include "bench/image/colouring.h"

namespace spherepair {

// Of the spheres that the backend has: contacts of the last collide(), metres, metres a second, or indices into
// Start::species.
std::vector<double> values_of(ColourBy by, const Start& start, Backend& backend, const Backend::State& state);

// values: of the first image. More starts than one are the frames of a film, which share their colours.
Colouring colouring_of(ColourBy by, const std::vector<Start>& starts, std::vector<double> values);

}  // namespace spherepair
