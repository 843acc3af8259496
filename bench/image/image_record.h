// SPDX-License-Identifier: MIT
// The JSON record next to an image.
#pragma once

#include "bench/formats/start.h"
#include "bench/legend/legend.h"
#include "common/backend/backend.h"
#include "common/image/antialiased_image.h"

namespace spherepair {

// Describes the spheres that the backend has drawn and the pairs that it has found by this method.
json image_record(const Start& start, Backend& backend, Method method, const ImageOptions& image, const Legend& legend);

}  // namespace spherepair
