// SPDX-License-Identifier: MIT
#include "glsl/table_windows.h"

#include <algorithm>

#include "common/device/launch.h"

namespace spherepair {

TableWindows::TableWindows(const Params& p, uint64_t longest)
    : words_(uint64_t(p.grid.cell_slots) + 2), longest_(longest), step_(words_) {
  if (words_ <= longest) return;
  // A sphere reads the ends of its rows of cells. The farthest lies one cell beyond its right neighbour in the next
  // layer's row.
  const uint64_t ahead = uint64_t(p.grid.cells_x) * p.grid.cells_y + p.grid.cells_x + 2;
  // Parts begin at multiples of 256 bytes, the largest alignment that GL lets a driver require. No parts if most of
  // each would serve neighbours only.
  constexpr uint64_t alignment = 256 / sizeof(uint);
  step_ = 2 * ahead <= longest ? (longest - ahead) / alignment * alignment : 0;
}

uint64_t TableWindows::count() const { return step_ ? (cells() + step_ - 1) / step_ : 0; }

// No dispatch reads what another writes, so there is no barrier between them.
void TableWindows::dispatch(uint64_t groups, GLuint table, GLuint program, BufferTextures& textures) const {
  for (uint64_t first = 0; first < cells(); first += step_) {
    const uint64_t behind = std::min(first + step_, cells()), texels = std::min(longest_, words_ - first);
    textures.bind({CELL_TEXTURE, GL_R32UI, table, first * sizeof(uint), texels * sizeof(uint)});
    glProgramUniform2ui(program, 0, uint(first), uint(behind));
    const auto share = folded(groups * (behind - first) / words_ + 1);
    glDispatchCompute(share[0], share[1], share[2]);
  }
}

}  // namespace spherepair
