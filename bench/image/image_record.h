// SPDX-License-Identifier: MIT
// What the JSON file next to an image says of it.
#pragma once

#include "bench/formats/start.h"
#include "bench/image/antialiased_image.h"
#include "bench/legend/legend.h"

namespace spherepair {

// Of the spheres that the backend has drawn, and the pairs that it has found by this method.
json image_record(const Start& start, Backend& backend, Method method, const ImageOptions& image, const Legend& legend);

}  // namespace spherepair
