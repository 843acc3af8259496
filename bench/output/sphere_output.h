// SPDX-License-Identifier: MIT
// Writes spheres: positions, radii and velocities. read_sphere_file reads all formats but .vtp back to the same float32
// bits.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "bench/npy/rows_file.h"
#include "common/scene/contact/contact_options.h"
#include "common/shared/layout.h"

namespace spherepair {

// Throws std::invalid_argument for an unknown extension of `option`'s file.
void check_sphere_output(const std::string& option, const std::string& file);

// Writes by the extension: .npy: a structured array of pos (3), radius and velo (3), float32; .vtp: VTK PolyData with
// radius and velocity, float32; .xyz or .extxyz: extended XYZ; .csv, .tsv, .txt, .dat or - (standard output): columns
// of text. Text has the fewest digits, nine at most, that give the same float32. Extended XYZ also has the box as
// Origin and Lattice, without periodic axes.
void write_spheres(const std::string& file, std::span<const vec4> positions, std::span<const vec4> velocities,
                   const std::optional<WallBox>& box = {});

// A frame of extended XYZ as text, with additional keys in the comment. Its file must be .xyz, .extxyz or -.
std::string xyz_frame(std::span<const vec4> positions, std::span<const vec4> velocities,
                      const std::optional<WallBox>& box, const std::string& keys);
// The bytes of a .vtp file.
void write_vtp(const Sink& sink, std::span<const vec4> positions, std::span<const vec4> velocities);

void check_xyz_output(const std::string& option, const std::string& file);

}  // namespace spherepair
