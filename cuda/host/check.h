// SPDX-License-Identifier: MIT
// cuda_check throws BackendError if a call of CUDA failed; `what` says what was tried.
#pragma once

#include <cuda_runtime.h>

#include <string>

#include "common/backend/backend.h"

namespace spherepair {

inline void cuda_check(cudaError_t error, const std::string& what) {
  if (error == cudaSuccess) return;
  throw BackendError("cuda: " + what + " failed: " + cudaGetErrorName(error) + ", " + cudaGetErrorString(error));
}

}  // namespace spherepair
