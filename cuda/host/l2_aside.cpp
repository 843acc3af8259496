// SPDX-License-Identifier: MIT
#include "cuda/host/l2_aside.h"

#include <algorithm>

#include "cuda/host/check.h"

namespace spherepair {

L2Aside::L2Aside(int device) {
  int most = 0, window = 0;
  cuda_check(cudaDeviceGetAttribute(&most, cudaDevAttrMaxPersistingL2CacheSize, device), "asking about L2");
  cuda_check(cudaDeviceGetAttribute(&window, cudaDevAttrMaxAccessPolicyWindowSize, device), "asking about L2");
  most_ = uint64_t(most);
  largest_window_ = uint64_t(window);
}

void L2Aside::turn(bool on) {
  if (on_ == on) return;
  cuda_check(cudaDeviceSetLimit(cudaLimitPersistingL2CacheSize, on ? most_ : 0), "setting L2 aside");
  if (!on) cuda_check(cudaCtxResetPersistingL2Cache(), "giving L2 back");
  on_ = on;
}

cudaAccessPolicyWindow L2Aside::window(void* data, uint64_t bytes) const {
  cudaAccessPolicyWindow window{};
  if (!on_ || !data || !bytes) return window;
  window.base_ptr = data;
  window.num_bytes = std::min(bytes, largest_window_);
  window.hitRatio = float(std::min(1.0, double(most_) / double(window.num_bytes)));
  window.hitProp = cudaAccessPropertyPersisting;
  window.missProp = cudaAccessPropertyStreaming;
  return window;
}

}  // namespace spherepair
