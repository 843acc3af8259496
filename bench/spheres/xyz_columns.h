// SPDX-License-Identifier: MIT
// The columns of an XYZ file, and what else its comment line says.
#pragma once

#include "bench/spheres/columns.h"

namespace spherepair {

// From Properties= in the comment line of extended XYZ; none without that key.
std::optional<Columns> named_columns(const FileBytes& file, uint64_t line, std::string_view comment);

// Classic XYZ, `[species] x y z [radius]`, from the first sphere's line.
Columns classic_columns(const FileBytes& file, uint64_t line, std::string_view text);

// The periodic box of an extended XYZ's comment line, in its words (Lattice="..." pbc="..."); empty where nothing is
// periodic: without these keys, or where pbc is false along every axis. A Lattice, or a cell, alone is periodic along
// all three.
std::string periodic_box(const FileBytes& file, uint64_t line, std::string_view comment);

}  // namespace spherepair
