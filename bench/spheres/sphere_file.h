// SPDX-License-Identifier: MIT
// Reads spheres from files of other programs: extended XYZ, LAMMPS dumps and data, NPY, NPZ, PLY and columns of text.
// Errors name the line or byte, what was expected and what was found.
#pragma once

#include <optional>
#include <string>

#include "bench/io/report.h"
#include "bench/spheres/sphere_rows.h"
#include "common/files/file_bytes.h"
#include "common/scene/scene.h"

namespace spherepair {

struct SphereFileOptions {
  std::optional<double> radius = {};      // of all spheres: required if the file has none, otherwise an error
  std::optional<uint64_t> frame = {};     // of a file with frames, counted from 0; default: the first
  std::vector<std::string> columns = {};  // words of --columns (column_names.h)
  bool decimal_comma = false;             // of text: 0,5 is a half
  bool ignore_radii = false;              // of the file: all spheres get the option's
  bool species = false;                   // reads a column of text; an error for formats without species
  bool ignore_periodic = false;           // drops a periodic box, an error without the next two
  bool moves_in_box = false;              // a periodic box becomes `box`, for motion with contacts
  bool exact = false;                     // fills `given`, a periodic box included, in place of the scene
  int threads = 0;                        // 0: all cores
};

struct SphereFile {
  Scene scene;        // rounded to float32; at rest if the file has no velocities
  ListProblem given;  // the file's spheres and box in float64, as one system
  std::string file, format;
  bool own_radii = false;            // else the radius is the option's
  bool unused_radii = false;         // the file has radii, which are ignored as asked for
  uint64_t values = 0, changed = 0;  // numbers read; those changed by rounding to float32
  uint64_t frame = 0, frames = 1;
  std::string periodic;              // the periodic box in the file's words, if `given` has one
  std::string ignored;               // the periodic box, if ignored
  std::string unread_box;            // a comment that mentions a box
  std::optional<WallBox> box = {};   // along the axes
  std::string units;                 // of lengths, in the file's words; empty if it has none
  bool at_rest = true;               // no sphere of the file has a velocity
  float largest_rounding = 0;        // how far it moved a surface at most
  std::vector<std::string> species;  // ascending, each once; empty unless asked for ...
  std::vector<uint> species_index;   // ... of each sphere
  bool unread_species = false;       // the file has species that were not asked for
  bool unread_momenta = false;       // the file has momenta but no velocities

  uint64_t size() const { return scene.size() + given.set.size(); }  // one of these is 0
};

// Reads a file by its extension. Without one it reads streams (-, pipes, /dev/fd/63) by their contents, and files with
// --columns as text. Throws std::invalid_argument, also for an unknown extension.
SphereFile read_sphere_file(const std::string& file, const SphereFileOptions& options);

// Reads all frames of a file in one pass. Species are those of all frames.
std::vector<SphereFile> read_sphere_frames(const std::string& file, const SphereFileOptions& options);

std::string describe(const SphereFile& input);        // all of these, and what rounding to float32 changed:
std::string describe_file(const SphereFile& input);   // format, frame, units
std::string box_warning(const SphereFile& input);     // empty if the file mentions no box
std::string describe_radii(const SphereFile& input);  // with the number of spheres
json to_json(const SphereFile& input);

// The readers of formats without frames (for the others see frames.h): they fill the fields of the format and the rows.
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

// For the readers. Converts binary numbers, and fills the input's fields about them, except the format.
void read_numbers(NumberTable table, const SphereFileOptions& options, SphereRows& rows, SphereFile& input);

// For the readers. Removes the column of radii if the options ignore it; false if there was none.
bool take_radii_away(Columns& columns, const SphereFileOptions& options);

// For the readers. Throws unless there is a radius either in the file or in the options.
void check_radius(const FileBytes& file, const Columns& columns, const SphereFileOptions& options);
int reading_threads(const SphereFileOptions& options);

// The text of what was expected instead of an invalid value; null for a valid one.
inline const char* why_invalid(double value, bool is_radius) {
  constexpr double beyond_float32 = 0x1.ffffffp127;  // from here on rounded to infinity
  if (!(value < beyond_float32 && value > -beyond_float32)) return "a finite number within the range of float32";
  return is_radius && value < 0 ? "a radius that is not negative" : nullptr;
}

}  // namespace spherepair
