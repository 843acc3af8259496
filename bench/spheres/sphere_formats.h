// SPDX-License-Identifier: MIT
// The table of file formats: readers, messages and help texts come from its rows.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "bench/spheres/frames.h"

namespace spherepair {

enum FormatTrait : unsigned { FORMAT_IS_TEXT = 1, FORMAT_HAS_BOXES = 2, FORMAT_HAS_SPECIES = 4 };

// A format has a reader of whole files or of frames.
struct SphereFormat {
  const char* name;
  std::array<std::string_view, 4> extensions;
  const char* contents;                    // for help texts
  bool (*begins)(std::string_view bytes);  // whether a stream has this format, if no earlier row claims it
  SphereFile (*read)(const FileBytes&, const SphereFileOptions&, SphereRows&);
  std::unique_ptr<Frames> (*open)(const FileBytes&, const SphereFileOptions&);
  unsigned traits;

  bool has(FormatTrait trait) const { return traits & trait; }
  std::string extensions_text() const;  // `.xyz, .extxyz`
};

std::span<const SphereFormat> sphere_formats();

// Finds the format by the file's extension, and for streams by their contents; text if --columns names the columns.
// Throws std::invalid_argument for an unknown format, and for options that the format does not take.
const SphereFormat& format_of(const FileBytes& file, const SphereFileOptions& options);

std::string describe_sphere_formats();  // all: `extended XYZ (.xyz, .extxyz; columns pos and ...), ...`
std::string names_of_framed();          // `extended XYZ and LAMMPS dump`
std::string names_of_formats(FormatTrait trait);

}  // namespace spherepair
