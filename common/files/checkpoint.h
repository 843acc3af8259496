// SPDX-License-Identifier: MIT
// The state of a run in a file or in memory, from which any backend continues to the same bits.
//
// The file is little-endian. First 8 bytes "SPHCHECK", then as 32-bit numbers the version (1), the motion method, the
// precision, the steps that `anchored` counts, whether all radii are equal, and the length of the scene's name; as
// float32 dt, gravity, plane and restitution; as 64-bit numbers n and the steps done. A run with contacts has version
// 5, and here their law, walls, both exponents of units (32-bit), the stiffness, the corners of the box, the drag, the
// skin and the density (float32). Version 2 lacks drag, skin and density, version 3 skin and density, version 4 the
// density. Then the name, and a 64-bit checksum of all so far. Then seven parts, each a 64-bit length in bytes, the
// bytes, and a 64-bit checksum of the bytes: positions, velocities (vec4[n] each), wide state, anchors, flights, steps
// of the anchors, due steps (as layout.h describes SLOT_WIDE to SLOT_NEXT_EVENT; empty if the method has none).
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "common/files/file_bytes.h"
#include "common/scene/motion_state.h"

namespace spherepair {

struct Checkpoint {
  Scene scene;         // parameters and current positions and velocities
  MotionState motion;  // Motion::save()
  uint64_t step = 0;   // steps done
};

// Atomically replaces the file. Both throw std::invalid_argument naming the file and the error: not a checkpoint,
// another version, inconsistent contents, or the part that is truncated or damaged.
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);
Checkpoint read_checkpoint(const FileBytes& file);
inline Checkpoint read_checkpoint(const std::filesystem::path& path) { return read_checkpoint(FileBytes(path)); }

// The bytes of such a file: their number, and calls of write() with one part after another.
uint64_t checkpoint_bytes(const Checkpoint& checkpoint);
void write_checkpoint(const Checkpoint& checkpoint, const std::function<void(std::string_view)>& write);

// The checksum after the header and after each part.
uint64_t checksum(std::string_view bytes);

}  // namespace spherepair
