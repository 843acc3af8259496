// SPDX-License-Identifier: MIT
// Reads text files with frames. A frame has some lines of its own, then one line per sphere.
#pragma once

#include <memory>

#include "bench/io/file_lines.h"
#include "bench/spheres/columns.h"
#include "bench/spheres/sphere_file.h"

namespace spherepair {

// The lines of a frame's spheres, in chunks; a thread reads one chunk at a time.
struct SphereLines {
  struct Chunk {
    FileLines start;
    uint64_t first_sphere, spheres;
  };
  uint64_t spheres = 0;
  std::vector<Chunk> chunks = {};
  std::vector<size_t> lists = {};  // PLY: the columns that a list precedes, its length and that many fields
  bool comments = false;           // LAMMPS data: # ends the numbers of a line
};

// Skips the lines of `spheres` spheres. Throws if the file ends earlier; `said` names the line with their number: line
// 2.
SphereLines pass_over_spheres(const FileBytes& file, FileLines& cursor, uint64_t spheres, const std::string& said,
                              const char* what = "sphere");

// The numbers of a LAMMPS file's box. Throws unless the words are `count` finite numbers.
std::vector<double> finite_numbers(const FileBytes& file, uint64_t line, std::span<const std::string> words,
                                   size_t count);

// Reads the number of spheres from a line of its own.
uint64_t read_sphere_count(const FileBytes& file, FileLines& cursor, const std::string& expected);

// Calls read_frame(cursor) at least once and until the file ends: all frames must be complete.
template <typename ReadFrame>
void for_frames(const FileBytes& file, ReadFrame read_frame) {
  require_text(file);
  FileLines cursor = lines_of(file);
  do {
    read_frame(cursor);
    cursor.skip_blank_lines();
  } while (!cursor.at_end());
}

// Reads the spheres, and fills the input's fields about their columns; input.format gets the columns in words, without
// the format's name. line: the line of the columns' names.
void read_sphere_lines(const FileBytes& file, uint64_t line, Columns columns, const SphereLines& lines,
                       const SphereFileOptions& options, SphereRows& rows, SphereFile& input);

// Takes, ignores or refuses a periodic box, as the options say. text: the box in the file's words; empty if nothing is
// periodic. where: the file and the place in it. box: the box, if it can be taken; else `wanted` says how it must be
// written. low: its lower corner.
void take_periodic_box(const std::string& where, const std::string& text, const std::optional<ListBox>& box,
                       const char* wanted, const SphereFileOptions& options, SphereFile& input, const Point3& low);

// The box with this lower corner; none if it is tilted. If one axis is periodic, others may have a length of 0.
std::optional<WallBox> box_along_axes(const ListBox& box, const Point3& low);

class Frames {
 public:
  virtual ~Frames() = default;
  virtual size_t count() const = 0;
  virtual SphereFile read(size_t frame, SphereRows& rows) const = 0;
};

// The readers of the formats. The file and the options must outlive the returned object.
std::unique_ptr<Frames> xyz_frames(const FileBytes& file, const SphereFileOptions& options);
std::unique_ptr<Frames> lammps_frames(const FileBytes& file, const SphereFileOptions& options);

}  // namespace spherepair
