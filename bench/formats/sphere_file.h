// SPDX-License-Identifier: MIT
// Spheres from the files of other programs: extended XYZ and NPY. A bad file is refused with the line or byte, what was
// expected there and what was found.
#pragma once

#include <optional>
#include <string>

#include "bench/io/file_bytes.h"
#include "bench/io/report.h"
#include "common/scene/scene.h"

namespace spherepair {

struct SphereFileOptions {
  std::optional<float> radius = {};    // of all spheres: needed where the file has none, an error where it has
  std::optional<uint64_t> frame = {};  // of an XYZ file, counted from 0; without it, the first
  int threads = 0;                     // 0: all cores
};

struct SphereFile {
  Scene scene;  // at rest
  std::string file, format;
  bool own_radii = false;            // else one was given for all
  uint64_t values = 0, changed = 0;  // numbers read; those that float32 cannot hold as they stand in the file
  uint64_t frame = 0, frames = 1;
};

bool is_sphere_file(const std::string& file);  // by its extension

// Throws std::invalid_argument, also for an extension that is not known.
SphereFile read_sphere_file(const std::string& file, const SphereFileOptions& options);

std::string describe(const SphereFile& input);
json to_json(const SphereFile& input);

// The formats' readers: they fill all of a SphereFile but its name and the velocities.
SphereFile read_npy(const FileBytes& file, const SphereFileOptions& options);
SphereFile read_xyz(const FileBytes& file, const SphereFileOptions& options);

// What both readers ask. A radius in the file and one for all exclude each other.
void check_radius(const FileBytes& file, bool own_radii, const SphereFileOptions& options);
int reading_threads(const SphereFileOptions& options);

// What should have stood in place of a value that no sphere can have; null for one that is fine.
inline const char* why_invalid(double value, bool is_radius) {
  constexpr double beyond_float32 = 0x1.ffffffp127;  // from here on it would round to infinity
  if (!(value < beyond_float32 && value > -beyond_float32)) return "a finite number within the range of float32";
  return is_radius && value < 0 ? "a radius that is not negative" : nullptr;
}

}  // namespace spherepair
