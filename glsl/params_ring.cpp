// SPDX-License-Identifier: MIT
#include "glsl/params_ring.h"

#include <cstring>

namespace spherepair {

void ParamsRing::make() {
  glCreateBuffers(1, &buffer_);
  glNamedBufferStorage(buffer_, slices * stride, nullptr, GL_DYNAMIC_STORAGE_BIT);
}

void ParamsRing::bind(const Params& params) {
  const auto same = [&](size_t slice) { return std::memcmp(&written_[slice], &params, sizeof(Params)) == 0; };
  if (bound_ < used_ && same(bound_)) return;
  size_t slice = 0;
  while (slice < used_ && !same(slice)) ++slice;
  if (slice == used_) {
    slice = next_;
    next_ = (next_ + 1) % slices;
    used_ = used_ < slices ? used_ + 1 : slices;
    written_[slice] = params;
    glNamedBufferSubData(buffer_, GLintptr(slice) * stride, sizeof(Params), &params);
  }
  bound_ = slice;
  glBindBufferRange(GL_UNIFORM_BUFFER, SLOT_PARAMS, buffer_, GLintptr(slice) * stride, sizeof(Params));
}

}  // namespace spherepair
