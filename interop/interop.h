// SPDX-License-Identifier: MIT
#pragma once

#include "common/backend/shared_drawing.h"

namespace spherepair {

std::unique_ptr<SharedDrawing> open_cuda_to_gl(Backend& cuda, const OpenOptions& options);

}  // namespace spherepair
