// SPDX-License-Identifier: MIT
#include "bench/spheres/sphere_file.h"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "bench/io/numbers.h"
#include "bench/spheres/frames.h"
#include "bench/text/fields.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

// A format is read whole, or frame by frame. Those with frames may have periodic boxes and species.
struct Format {
  const char* name;
  std::array<std::string_view, 4> extensions;
  SphereFile (*read)(const FileBytes&, const SphereFileOptions&, SphereRows&);
  std::unique_ptr<Frames> (*open)(const FileBytes&, const SphereFileOptions&);
  bool is_text = true;
};
constexpr Format formats[] = {{"extended XYZ", {".xyz", ".extxyz"}, nullptr, xyz_frames},
                              {"LAMMPS dump", {".lammpstrj", ".dump"}, nullptr, lammps_frames},
                              {"NPY", {".npy"}, read_npy, nullptr, false},
                              {"columns of text", {".txt", ".csv", ".tsv", ".dat"}, read_text, nullptr}};
constexpr const Format &xyz = formats[0], &lammps = formats[1], &npy = formats[2], &text = formats[3];

std::string known_formats() {
  std::vector<std::string> known;
  for (const Format& format : formats) {
    const auto end = std::ranges::find(format.extensions, "");
    known.push_back(fmt::format("{} ({})", fmt::join(format.extensions.begin(), end, ", "), format.name));
  }
  return fmt::format("{}", fmt::join(known, ", "));
}

std::string names_of_framed() {
  std::vector<std::string_view> names;
  for (const Format& format : formats)
    if (format.open) names.push_back(format.name);
  return fmt::format("{}", fmt::join(names, " and "));
}

// Of a stream: NPY by its magic string, a dump by its first item, XYZ by its first line, which is a number alone.
const Format& format_by_contents(const FileBytes& file) {
  const std::string_view bytes = file.bytes();
  if (bytes.starts_with("\x93NUMPY")) return npy;
  if (bytes.starts_with("ITEM:")) return lammps;
  std::vector<std::string_view> fields;
  split_fields(bytes.substr(0, bytes.find_first_of("\r\n")), 2, fields);
  return fields.size() == 1 && whole_number_of(fields[0], 0, UINT64_MAX) ? xyz : text;
}

const Format& format_of(const FileBytes& file, const SphereFileOptions& options) {
  const std::string extension = lower_case(std::filesystem::path(file.name()).extension().string());
  for (const Format& format : formats)
    if (!extension.empty() && std::ranges::count(format.extensions, extension)) return format;
  if (file.is_stream()) return format_by_contents(file);
  if (!options.columns.empty()) return text;
  if (const std::string_view kind = kind_of(file.bytes()); !kind.empty())
    throw std::invalid_argument(fmt::format("{} is {}: unpack or convert it to XYZ, NPY or text", file.name(), kind));
  throw std::invalid_argument(fmt::format(
      "cannot tell the format of {} by its extension; known are {}; other text needs --columns x,y,z,radius",
      file.name(), known_formats()));
}

// Throws for options that the format does not take.
const Format& checked_format(const FileBytes& file, const SphereFileOptions& options) {
  if (options.radius && why_invalid(*options.radius, true))
    throw std::invalid_argument(fmt::format("--radius is {}, but must be finite and not negative", *options.radius));
  const Format& format = format_of(file, options);
  const auto refuse_if = [&](bool wanted, const char* what, const std::string& instead) {
    if (wanted)
      throw std::invalid_argument(fmt::format("{} ({}) has no {}: {}", file.name(), format.name, what, instead));
  };
  const std::string framed = names_of_framed();
  refuse_if(options.decimal_comma && !format.is_text, "decimal comma", "--decimal-comma is for text, omit it");
  refuse_if(options.frame && !format.open, "frames", fmt::format("--frame is for {}, omit it", framed));
  refuse_if(options.ignore_periodic && !format.open, "periodic box",
            fmt::format("{} may have one, omit --ignore-periodic", framed));
  refuse_if(options.species && !format.open, "species",
            fmt::format("{} may have some, choose another --color", framed));
  return format;
}

SphereFile read_frame(const FileBytes& file, const Frames& frames, uint64_t wanted, SphereRows& rows) {
  if (wanted >= frames.count())
    throw std::invalid_argument(fmt::format("{} has {}, counted from 0, so --frame {} is not among them", file.name(),
                                            counted(frames.count(), "frame"), wanted));
  SphereFile input = frames.read(wanted, rows);
  input.frame = wanted;
  input.frames = frames.count();
  return input;
}

SphereFile read_one(const FileBytes& file, const SphereFileOptions& options, SphereRows& rows) {
  const Format& format = checked_format(file, options);
  if (!format.open) return format.read(file, options, rows);
  SphereFile input = read_frame(file, *format.open(file, options), options.frame.value_or(0), rows);
  if (options.ignore_periodic && input.ignored.empty())
    throw std::invalid_argument(fmt::format("{} has no periodic box: omit --ignore-periodic", file.name()));
  return input;
}

void complete(SphereFile& input, SphereRows& rows, const FileBytes& bytes, const SphereFileOptions& options) {
  input.file = bytes.name();
  input.ignores_radii = options.ignore_radii;
  input.at_rest = std::ranges::all_of(rows.velocities, [](const vec4& v) { return v.x == 0 && v.y == 0 && v.z == 0; });
  if (input.periodic) {
    PointSet& set = input.periodic->set;
    for (const auto& [x, y, z, radius] : rows.exact) set.points.push_back({x, y, z}), set.radii.push_back(radius);
    set.offsets = {0, set.size()};
  }
  if (!input.periodic) input.rounding = round_rows(rows, options.may_shift);
  Scene& scene = input.scene;
  scene.name = std::filesystem::path(bytes.name()).filename().string();
  scene.positions = std::move(rows.positions);
  scene.velocities = std::move(rows.velocities);
  scene.velocities.resize(scene.size(), vec4{0, 0, 0, 0});
  scene.equal_radii = std::ranges::all_of(
      scene.positions, [&](const vec4& p) { return float_bits(p.w) == float_bits(scene.positions.front().w); });
}

// The same names for all frames.
void index_species(std::span<SphereFile> frames, std::span<const SphereRows> rows) {
  std::map<std::string_view, uint> index;
  for (const SphereRows& each : rows)
    for (const std::string_view name : each.species) index.emplace(name, 0);
  std::vector<std::string> names;
  for (auto& [name, k] : index) k = uint(names.size()), names.emplace_back(name);
  for (size_t k = 0; k < frames.size(); ++k) {
    frames[k].species = names;
    for (const std::string_view name : rows[k].species) frames[k].species_index.push_back(index.at(name));
  }
}

}  // namespace

SphereFile read_sphere_file(const std::string& file, const SphereFileOptions& options) {
  const FileBytes bytes(file);
  SphereRows rows;
  SphereFile input = read_one(bytes, options, rows);
  index_species({&input, 1}, {&rows, 1});
  complete(input, rows, bytes, options);
  return input;
}

std::vector<SphereFile> read_sphere_frames(const std::string& file, const SphereFileOptions& options) {
  const FileBytes bytes(file);
  const Format& format = checked_format(bytes, options);
  if (!format.open)
    throw std::invalid_argument(
        fmt::format("{} ({}) has no frames: --frames draws those of {}", bytes.name(), format.name, names_of_framed()));
  const std::unique_ptr<Frames> all = format.open(bytes, options);
  std::vector<SphereRows> rows(all->count());
  std::vector<SphereFile> frames;
  for (size_t k = 0; k < rows.size(); ++k) frames.push_back(read_frame(bytes, *all, k, rows[k]));
  index_species(frames, rows);
  for (size_t k = 0; k < frames.size(); ++k) complete(frames[k], rows[k], bytes, options);
  return frames;
}

bool take_radii_away(Columns& columns, const SphereFileOptions& options) {
  const bool taken = options.ignore_radii && columns.has(QUANTITY_RADIUS);
  if (taken) columns.columns[QUANTITY_RADIUS].reset();
  return taken;
}

void check_radius(const FileBytes& file, const Columns& columns, const SphereFileOptions& options) {
  const bool own_radii = columns.has(QUANTITY_RADIUS);
  if (own_radii && options.radius && columns.by_order)
    throw std::invalid_argument(fmt::format(
        "{} has {} columns, read as {}, and --radius gives one radius for all: omit --radius if column {} holds radii, "
        "else name the columns, such as --columns {}x,y,z{}",
        file.name(), columns.count, columns.text, *columns.columns[QUANTITY_RADIUS] + 1,
        columns.species ? "species," : "", columns.count == 7 ? ",_,_,_,_" : ",_"));
  if (own_radii && options.radius)
    throw std::invalid_argument(
        fmt::format("{} has a radius for each sphere and --radius gives one for all: leave --radius out, or the radii",
                    file.name()));
  if (!own_radii && !options.radius)
    throw std::invalid_argument(
        fmt::format("{} has no radii (its columns: {}): give the radius of all spheres with "
                    "--radius, or the column of radii with --columns",
                    file.name(), columns.text));
}

bool radius_is_rounded(const SphereFileOptions& options) {
  return options.radius && double(float(*options.radius)) != *options.radius;
}

int reading_threads(const SphereFileOptions& options) {
  return options.threads > 0 ? options.threads : omp_get_max_threads();
}

}  // namespace spherepair
