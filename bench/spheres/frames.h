// SPDX-License-Identifier: MIT
// Text files with frames. A frame has some lines of its own, then one line per sphere.
#pragma once

#include <memory>

#include "bench/io/file_lines.h"
#include "bench/spheres/columns.h"
#include "bench/spheres/sphere_file.h"

namespace spherepair {

// The lines of a frame's spheres, in chunks of which a thread reads one at a time.
struct SphereLines {
  struct Chunk {
    FileLines start;
    uint64_t first_sphere, spheres;
  };
  uint64_t spheres = 0;
  std::vector<Chunk> chunks = {};
  std::vector<size_t> lists = {};  // of PLY: before which column there is a list, its length and so many fields
  bool comments = false;           // of LAMMPS's data: # ends the numbers of a line
};

// Passes over the lines of so many spheres; throws where the file ends before, which `said` names: line 2.
SphereLines pass_over_spheres(const FileBytes& file, FileLines& cursor, uint64_t spheres, const std::string& said,
                              const char* what = "sphere");

// Of the box of a LAMMPS file: throws unless the words are so many finite numbers.
std::vector<double> finite_numbers(const FileBytes& file, uint64_t line, std::span<const std::string> words,
                                   size_t count);

// A number of spheres, in a line of its own.
uint64_t read_sphere_count(const FileBytes& file, FileLines& cursor, const std::string& expected);

// Calls read_frame(cursor) until the file ends, once at least: all frames must be complete.
template <typename ReadFrame>
void for_frames(const FileBytes& file, ReadFrame read_frame) {
  require_text(file);
  FileLines cursor = lines_of(file);
  do {
    read_frame(cursor);
    cursor.skip_blank_lines();
  } while (!cursor.at_end());
}

// Reads the spheres, and fills what the input says of their columns; `format` are these in words, without the format's
// name. `line` is that of the columns' names.
void read_sphere_lines(const FileBytes& file, uint64_t line, Columns columns, const SphereLines& lines,
                       const SphereFileOptions& options, SphereRows& rows, SphereFile& input);

// A periodic box, in the file's words (`text`; empty where nothing is periodic): taken, ignored or refused, as the
// options say. `where`: the file and the place in it. box: if it can be taken; else `wanted` says how it must be
// written.
void take_periodic_box(const std::string& where, const std::string& text, const std::optional<ListBox>& box,
                       const char* wanted, const SphereFileOptions& options, SphereFile& input);

class Frames {
 public:
  virtual ~Frames() = default;
  virtual size_t count() const = 0;
  virtual SphereFile read(size_t frame, SphereRows& rows) const = 0;
};

// The readers of the formats. The file and the options must outlive what they return.
std::unique_ptr<Frames> xyz_frames(const FileBytes& file, const SphereFileOptions& options);
std::unique_ptr<Frames> lammps_frames(const FileBytes& file, const SphereFileOptions& options);

}  // namespace spherepair
