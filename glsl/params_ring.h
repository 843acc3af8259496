// SPDX-License-Identifier: MIT
// Holds the parameters of the latest launches in slices of one buffer; a launch binds its slice. Writing parameters by
// glNamedBufferSubData costs 4 us between two dispatches; binding another slice costs nothing (NVIDIA H200).
#pragma once

#include <epoxy/gl.h>

#include <array>
#include <cstdint>

#include "common/shared/layout.h"

namespace spherepair {

class ParamsRing {
 public:
  void make();  // call all of these in one current context
  void bind(const Params& params);
  void forget() { glDeleteBuffers(1, &buffer_); }

 private:
  static constexpr GLintptr stride = 512;  // bytes: a multiple of every driver's alignment, which is 256 at most
  static constexpr size_t slices = 16;

  GLuint buffer_ = 0;
  std::array<Params, slices> written_{};
  size_t used_ = 0, next_ = 0;  // slices that were written; the one to write next
  size_t bound_ = slices;       // none
};

}  // namespace spherepair
