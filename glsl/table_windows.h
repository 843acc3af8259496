// SPDX-License-Identifier: MIT
// The table of cells where it is longer than a texture buffer may be: parts of it, each for the spheres of its own
// cells and long enough for their neighbourhoods, so that one dispatch a part reads one texture each.
#pragma once

#include "common/shared/layout.h"
#include "glsl/buffer_texture.h"

namespace spherepair {

class TableWindows {
 public:
  // Of a dense grid, for textures of at most so many words.
  TableWindows(const Params& p, uint64_t longest);

  uint64_t words() const { return words_; }  // of the table: a word a cell, the end of the last, and one more
  uint64_t count() const;                    // 1: it is one texture; 0: a neighbourhood does not fit into one

  // The search of all cells by so many groups or a few more, through the program in use: collide_grid of this variant.
  void dispatch(uint64_t groups, GLuint table, GLuint program, BufferTextures& textures) const;

 private:
  uint64_t cells() const { return words_ - 2; }

  uint64_t words_, longest_;
  uint64_t step_ = 0;  // cells of a part
};

}  // namespace spherepair
