// SPDX-License-Identifier: MIT
// Reads spheres from files of other programs: extended XYZ, LAMMPS dumps and data, NPY, NPZ, PLY and columns of text.
// Errors name the line or byte, what was expected and what was found.
#pragma once

#include <optional>
#include <string>

#include "bench/io/file_bytes.h"
#include "bench/io/report.h"
#include "bench/spheres/rounding.h"
#include "common/lists/list_problem.h"
#include "common/scene/scene.h"

namespace spherepair {

struct SphereFileOptions {
  std::optional<double> radius = {};      // of all spheres: required if the file has none, otherwise an error
  std::optional<uint64_t> frame = {};     // of a file with frames, counted from 0; default: the first
  std::vector<std::string> columns = {};  // words of --columns (column_names.h)
  bool decimal_comma = false;             // of text: 0,5 is a half
  bool ignore_radii = false;              // of the file: all spheres have the option's
  bool species = false;                   // required if asked for: a column of text, of a format with species
  bool ignore_periodic = false;           // a periodic box is an error otherwise ...
  bool take_periodic = false;             // ... unless it is taken
  bool may_shift = false;                 // by a vector, where that changes no difference of two numbers
  int threads = 0;                        // 0: all cores
};

// Spheres in a periodic box, in the file's own numbers.
struct PeriodicSpheres {
  ListBox box;
  PointSet set;
  std::string text;  // Lattice="..." pbc="..."
};

struct SphereFile {
  Scene scene;  // at rest where the file has no velocities
  std::string file, format;
  bool own_radii = false;            // otherwise the option's
  bool ignores_radii = false;        // as asked for ...
  bool unused_radii = false;         // ... of a file that has some
  uint64_t values = 0, changed = 0;  // numbers read; those changed by rounding to float32
  uint64_t frame = 0, frames = 1;
  std::string ignored;              // the periodic box
  std::string unread_box;           // a comment that has a word for a box
  std::optional<WallBox> box = {};  // along the axes, with no periodic one
  std::optional<PeriodicSpheres> periodic = {};
  std::string units;    // of lengths, in the file's words; empty if it has none
  bool at_rest = true;  // no sphere of the file has a velocity
  Rounding rounding;
  std::vector<std::string> species;  // ascending, each once; empty unless asked for ...
  std::vector<uint> species_index;   // ... of each sphere
  bool unread_species = false;       // that were not asked for
  bool unread_momenta = false;       // without velocities
};

// By the file's extension; without one, streams (-, pipes, /dev/fd/63) by their contents, and files whose columns are
// named as text. Throws std::invalid_argument, also for an unknown extension.
SphereFile read_sphere_file(const std::string& file, const SphereFileOptions& options);

// All frames of a file, which is read once. Species are those of all frames.
std::vector<SphereFile> read_sphere_frames(const std::string& file, const SphereFileOptions& options);

std::string describe(const SphereFile& input);           // all of these:
std::string describe_file(const SphereFile& input);      // format, frame, units
std::string box_warning(const SphereFile& input);        // empty without a word for a box
std::string describe_radii(const SphereFile& input);     // with the number of spheres
std::string describe_digits(const SphereFile& input);    // how many are lost, and the shift
std::string describe_rounding(const SphereFile& input);  // how far it moves a surface; empty if not
json to_json(const SphereFile& input);

// The readers of formats without frames: they fill the format's fields and the rows. Of the others: frames.h.
struct Columns;
struct NumberColumn;
struct NumberTable;
struct SphereRows;
SphereFile read_lammps_data(const FileBytes& file, const SphereFileOptions& options, SphereRows& rows);
SphereFile read_npy(const FileBytes& file, const SphereFileOptions& options, SphereRows& rows);
SphereFile read_npz(const FileBytes& file, const SphereFileOptions& options, SphereRows& rows);
SphereFile read_ply(const FileBytes& file, const SphereFileOptions& options, SphereRows& rows);
SphereFile read_text(const FileBytes& file, const SphereFileOptions& options, SphereRows& rows);

double number_at(const NumberColumn& column, uint64_t row);

// For the readers. Converts binary numbers, and fills what the input says of them but the format.
void read_numbers(NumberTable table, const SphereFileOptions& options, SphereRows& rows, SphereFile& input);

// For the readers. Takes the column of radii away if asked for; false if there was none to take.
bool take_radii_away(Columns& columns, const SphereFileOptions& options);

// For the readers. Throws unless there is a radius either in the file or in the options.
void check_radius(const FileBytes& file, const Columns& columns, const SphereFileOptions& options);
int reading_threads(const SphereFileOptions& options);
bool radius_is_rounded(const SphereFileOptions& options);  // the one of the options

// What was expected instead of an invalid value; null for a valid one.
inline const char* why_invalid(double value, bool is_radius) {
  constexpr double beyond_float32 = 0x1.ffffffp127;  // from here on rounded to infinity
  if (!(value < beyond_float32 && value > -beyond_float32)) return "a finite number within the range of float32";
  return is_radius && value < 0 ? "a radius that is not negative" : nullptr;
}

}  // namespace spherepair
