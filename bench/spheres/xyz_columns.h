// SPDX-License-Identifier: MIT
// Reads the columns, the box and other facts from the comment line of an XYZ file.
#pragma once

#include "bench/text/column_names.h"
#include "bench/text/xyz_comment.h"
#include "common/files/file_bytes.h"
#include "common/lists/list_problem.h"
#include "common/scene/contact/contact_options.h"

namespace spherepair {

// A comment line and its place.
struct Comment {
  const FileBytes& file;
  uint64_t line = 0;
  std::string_view text = {};
  std::vector<CommentPair> pairs = parse_comment(text);
};

// The names in Properties= of extended XYZ, each a number of columns; none without that key. by_names: throws
// for known names of another type or number of columns.
std::optional<std::vector<NamedColumn>> properties_of(const Comment& comment, bool by_names);

// The columns of these names; notes whether there are momenta.
Columns columns_of_properties(const Comment& comment, std::span<const NamedColumn> properties);

// Classic XYZ, `[species] x y z [radius]`, from the fields of the first sphere's line. types: the first number is whole
// in every line and the radius is an option's, so the number is a type, as LAMMPS writes it.
Columns classic_columns(const FileBytes& file, uint64_t line, std::string_view text, bool types);

// The periodic box of the comment line, in its words (Lattice="..." pbc="..."). Empty without these keys, or if pbc is
// false along every axis. A Lattice, cell or box without pbc is periodic along all three.
struct PeriodicBox {
  std::string text = {};
  std::optional<ListBox> box = {};  // from a Lattice of nine numbers: the rows of the box one after another
  std::string mention = {};         // the comment, if it mentions a box that is not read
};
PeriodicBox periodic_box(const Comment& comment);

// The box of a comment line with Lattice and pbc="F F F": the corner is Origin, or 0, and the edges lie along the axes.
std::optional<WallBox> closed_box(const Comment& comment);

// Its Origin, or 0; none if it is not three numbers.
std::optional<Point3> origin_of(const Comment& comment);

}  // namespace spherepair
