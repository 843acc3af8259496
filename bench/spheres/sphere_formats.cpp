// SPDX-License-Identifier: MIT
#include "bench/spheres/sphere_formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <stdexcept>

#include "bench/io/numbers.h"
#include "bench/text/fields.h"

namespace spherepair {
namespace {

bool begins_as_xyz(std::string_view bytes) {
  std::vector<std::string_view> fields;
  split_fields(bytes.substr(0, bytes.find_first_of("\r\n")), 2, fields);
  return fields.size() == 1 && whole_number_of(fields[0], 0, UINT64_MAX);
}
bool begins_as_dump(std::string_view bytes) { return bytes.starts_with("ITEM:"); }
// Whether a stream begins with a comment and the number of atoms, as LAMMPS data.
bool begins_as_data(std::string_view bytes) {
  FileLines cursor{bytes};
  cursor.next();
  while (!cursor.at_end())
    if (const std::vector<std::string> words = words_in(cursor.next()); !words.empty())
      return words.size() == 2 && whole_number_of(words[0], 0, UINT64_MAX) && words[1] == "atoms";
  return false;
}
bool begins_as_npy(std::string_view bytes) { return bytes.starts_with("\x93NUMPY"); }
bool begins_as_npz(std::string_view bytes) { return bytes.starts_with("PK\3\4"); }
bool begins_as_ply(std::string_view bytes) { return bytes.starts_with("ply\n") || bytes.starts_with("ply\r\n"); }
bool begins_as_text(std::string_view) { return true; }

constexpr unsigned text_with_boxes = FORMAT_IS_TEXT | FORMAT_HAS_BOXES | FORMAT_HAS_SPECIES;
constexpr SphereFormat formats[] = {
    {"extended XYZ",
     {".xyz", ".extxyz"},
     "columns pos and radius by Properties=, else `[species] x y z [radius]`; a periodic box by Lattice= and pbc=",
     begins_as_xyz,
     nullptr,
     xyz_frames,
     text_with_boxes},
    {"LAMMPS dump",
     {".lammpstrj", ".dump"},
     "columns x y z or xu yu zu, and radius or diameter; species by element or type",
     begins_as_dump,
     nullptr,
     lammps_frames,
     text_with_boxes},
    {"LAMMPS data",
     {".data", ".lmp"},
     "`Atoms # sphere`, atomic, charge, full, molecular ...; a periodic box; species by type",
     begins_as_data,
     read_lammps_data,
     nullptr,
     text_with_boxes},
    {"NPY",
     {".npy"},
     "n x 3, n x 4 with the radius, or structured with fields x y z or pos, and radius; any real numbers",
     begins_as_npy,
     read_npy,
     nullptr,
     0},
    {"NPZ",
     {".npz"},
     "arrays positions or centers, n x 3, and radii, n; or spheres, n x 4; box and pbc",
     begins_as_npz,
     read_npz,
     nullptr,
     FORMAT_HAS_BOXES},
    {"PLY",
     {".ply"},
     "text or binary; properties x y z and radius of the element vertex",
     begins_as_ply,
     read_ply,
     nullptr,
     0},
    {"columns of text",
     {".txt", ".csv", ".tsv", ".dat"},
     "named in the first line, else x y z [radius]",
     begins_as_text,
     read_text,
     nullptr,
     FORMAT_IS_TEXT}};
constexpr const SphereFormat& text = formats[std::size(formats) - 1];

std::string names_where(const std::function<bool(const SphereFormat&)>& wanted) {
  std::vector<std::string_view> names;
  for (const SphereFormat& format : formats)
    if (wanted(format)) names.push_back(format.name);
  const std::string_view last = names.back();
  names.pop_back();
  return fmt::format("{}{}{}", fmt::join(names, ", "), names.empty() ? "" : " and ", last);
}

const SphereFormat& known_format(const FileBytes& file, bool named_columns) {
  const std::string extension = lower_case(std::filesystem::path(file.name()).extension().string());
  for (const SphereFormat& format : formats)
    if (!extension.empty() && std::ranges::count(format.extensions, extension)) return format;
  if (file.is_stream())
    return *std::ranges::find_if(formats, [&](const SphereFormat& format) { return format.begins(file.bytes()); });
  if (named_columns) return text;
  if (const std::string_view kind = kind_of(file.bytes()); !kind.empty())
    throw std::invalid_argument(fmt::format("{} is {}: unpack or convert it to XYZ, NPY or text", file.name(), kind));
  std::vector<std::string> known;
  for (const SphereFormat& format : formats)
    known.push_back(fmt::format("{} ({})", format.extensions_text(), format.name));
  throw std::invalid_argument(fmt::format(
      "cannot tell the format of {} by its extension; known are {}; other text needs --columns x,y,z,radius",
      file.name(), fmt::join(known, ", ")));
}

}  // namespace

std::string SphereFormat::extensions_text() const {
  return fmt::format("{}", fmt::join(extensions.begin(), std::ranges::find(extensions, ""), ", "));
}

std::span<const SphereFormat> sphere_formats() { return formats; }

const SphereFormat& format_of(const FileBytes& file, const SphereFileOptions& options) {
  if (options.radius && why_invalid(*options.radius, true))
    throw std::invalid_argument(fmt::format("--radius is {}, but must be finite and not negative", *options.radius));
  const SphereFormat& format = known_format(file, !options.columns.empty());
  const auto refuse_if = [&](bool wanted, const char* what, const std::string& instead) {
    if (wanted)
      throw std::invalid_argument(fmt::format("{} ({}) has no {}: {}", file.name(), format.name, what, instead));
  };
  refuse_if(options.decimal_comma && !format.has(FORMAT_IS_TEXT), "decimal comma",
            "--decimal-comma is for text, omit it");
  refuse_if(options.frame && !format.open, "frames", fmt::format("--frame is for {}, omit it", names_of_framed()));
  refuse_if(options.ignore_periodic && !format.has(FORMAT_HAS_BOXES), "periodic box",
            fmt::format("{} may have one, omit --ignore-periodic", names_of_formats(FORMAT_HAS_BOXES)));
  refuse_if(options.species && !format.has(FORMAT_HAS_SPECIES), "species",
            fmt::format("{} may have some, choose another --color", names_of_formats(FORMAT_HAS_SPECIES)));
  return format;
}

std::string describe_sphere_formats() {
  std::vector<std::string> described;
  for (const SphereFormat& format : formats)
    described.push_back(fmt::format("{} ({}; {})", format.name, format.extensions_text(), format.contents));
  return fmt::format("{}", fmt::join(described, ", "));
}

std::string names_of_framed() {
  return names_where([](const SphereFormat& format) { return format.open != nullptr; });
}
std::string names_of_formats(FormatTrait trait) {
  return names_where([=](const SphereFormat& format) { return format.has(trait); });
}

}  // namespace spherepair
