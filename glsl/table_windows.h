// SPDX-License-Identifier: MIT
// Splits a table of cells that is longer than a texture buffer may be. Each part has the spheres of its own cells and
// is long enough for their neighbourhoods, so that a dispatch a part reads one texture.
#pragma once

#include "common/shared/layout.h"
#include "glsl/buffer_texture.h"

namespace spherepair {

class TableWindows {
 public:
  // For a dense grid and textures of at most `longest` words.
  TableWindows(const Params& p, uint64_t longest);

  uint64_t words() const { return words_; }  // of the table: a word a cell, the end of the last, and one more
  uint64_t count() const;                    // of parts; 1: one texture; 0: a neighbourhood does not fit into a texture

  // Searches all cells with `groups` groups or a few more. The program in use must be collide_grid of this variant.
  void dispatch(uint64_t groups, GLuint table, GLuint program, BufferTextures& textures) const;

 private:
  uint64_t cells() const { return words_ - 2; }

  uint64_t words_, longest_;
  uint64_t step_ = 0;  // cells of a part
};

}  // namespace spherepair
