// SPDX-License-Identifier: MIT
// Writes spheres as read_sphere_file reads them, to the same float32 bits: positions, radii and velocities.
#pragma once

#include <span>
#include <string>

#include "common/shared/layout.h"

namespace spherepair {

// Throws std::invalid_argument for an unknown extension of `option`'s file.
void check_sphere_output(const std::string& option, const std::string& file);

// By the extension: .npy, a structured array of pos (3), radius and velo (3), float32; .xyz or .extxyz, extended XYZ;
// .csv, .tsv, .txt, .dat or - (standard output), columns of text. Text has the fewest digits, nine at most, that give
// the same float32.
void write_spheres(const std::string& file, std::span<const vec4> positions, std::span<const vec4> velocities);

}  // namespace spherepair
