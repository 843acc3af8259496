// SPDX-License-Identifier: MIT
// CUDA's spheres drawn through OpenGL: three ways to hand them over.
#pragma once

#include <memory>

#include "common/backend/backend.h"

namespace spherepair {

enum class Transfer {
  host,        // read back by CUDA, written again by OpenGL
  registered,  // copied into OpenGL's buffers, which CUDA maps once a frame, both in one call
  imported     // copied into memory of CUDA's that OpenGL has imported for good
};
const char* transfer_name(Transfer way);

class SharedDrawing {
 public:
  virtual ~SharedDrawing() = default;

  // What the CUDA backend holds, positions and contacts by sphere index, is OpenGL's when this returns, and
  // OpenGL is done with what it had before.
  virtual void transfer(Transfer way) = 0;

  virtual void draw(DrawMethod method, const View& view) = 0;  // of what was transferred last; not compute
  virtual std::vector<uint> image() = 0;
  virtual void finish() = 0;  // waits for both APIs
};

}  // namespace spherepair
