// SPDX-License-Identifier: MIT
#include "bench/spheres/sphere_file.h"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "bench/io/numbers.h"
#include "bench/text/fields.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

using Reader = SphereFile (*)(const FileBytes&, const SphereFileOptions&, SphereRows&);
struct Format {
  const char* extension;
  Reader read;
};
constexpr Format formats[] = {{".xyz", read_xyz},  {".extxyz", read_xyz}, {".npy", read_npy}, {".txt", read_text},
                              {".csv", read_text}, {".tsv", read_text},   {".dat", read_text}};

// Of a stream: NPY by its magic string, XYZ by its first line, which is a number alone.
Reader reader_by_contents(const FileBytes& file) {
  const std::string_view bytes = file.bytes();
  if (bytes.starts_with("\x93NUMPY")) return read_npy;
  std::vector<std::string_view> fields;
  split_fields(bytes.substr(0, bytes.find_first_of("\r\n")), 2, fields);
  return fields.size() == 1 && whole_number_of(fields[0], 0, UINT64_MAX) ? read_xyz : read_text;
}

Reader reader_of(const FileBytes& file, const SphereFileOptions& options) {
  const std::string extension = lower_case(std::filesystem::path(file.name()).extension().string());
  const auto found = std::ranges::find_if(formats, [&](const Format& format) { return extension == format.extension; });
  if (found != std::end(formats)) return found->read;
  if (file.is_stream()) return reader_by_contents(file);
  if (!options.columns.empty()) return read_text;
  if (const std::string_view kind = kind_of(file.bytes()); !kind.empty())
    throw std::invalid_argument(fmt::format("{} is {}: unpack or convert it to XYZ, NPY or text", file.name(), kind));
  throw std::invalid_argument(
      fmt::format("cannot tell the format of {} by its extension; known are .xyz and .extxyz (XYZ, extended XYZ), .npy "
                  "(NPY) and .txt, .csv, .tsv, .dat (columns of text); other text needs --columns x,y,z,radius",
                  file.name()));
}

std::pair<float, float> radius_range(const Scene& scene) {
  if (scene.size() == 0) return {0, 0};
  const auto [low, high] = std::ranges::minmax_element(scene.positions, {}, &vec4::w);
  return {low->w, high->w};
}

// Throws for options that the format does not take.
Reader checked_reader(const FileBytes& bytes, const SphereFileOptions& options) {
  if (options.radius && why_invalid(*options.radius, true))
    throw std::invalid_argument(fmt::format("--radius is {}, but must be finite and not negative", *options.radius));
  const Reader read = reader_of(bytes, options);
  if (options.decimal_comma && read == read_npy)
    throw std::invalid_argument(
        fmt::format("--decimal-comma is for text, but {} is an NPY file: omit it", bytes.name()));
  if (options.ignore_periodic && read != read_xyz)
    throw std::invalid_argument(
        fmt::format("{} has no periodic box: only XYZ files have; omit --ignore-periodic", bytes.name()));
  if (options.species && read != read_xyz)
    throw std::invalid_argument(
        fmt::format("{} has no species: only XYZ files have; choose another --color", bytes.name()));
  return read;
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
  const Reader read = checked_reader(bytes, options);
  SphereRows rows;
  SphereFile input = read(bytes, options, rows);
  index_species({&input, 1}, {&rows, 1});
  complete(input, rows, bytes, options);
  return input;
}

std::vector<SphereFile> read_sphere_frames(const std::string& file, const SphereFileOptions& options) {
  const FileBytes bytes(file);
  if (checked_reader(bytes, options) != read_xyz)
    throw std::invalid_argument(fmt::format("{} has no frames: --frames draws those of an XYZ file", bytes.name()));
  std::vector<SphereRows> rows;
  std::vector<SphereFile> frames = read_xyz_frames(bytes, options, rows);
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

std::string box_warning(const SphereFile& input) {
  if (input.unread_box.empty()) return "";
  return fmt::format(
      "WARNING: a comment has a word for a box, which is not read: {}; pairs across a periodic boundary are not "
      "found\n",
      in_quotes(input.unread_box));
}

std::string describe_file(const SphereFile& input) {
  std::string text = fmt::format("{}: {}", input.file, input.format);
  if (input.frames > 1)
    text += fmt::format(", frame {} of {} (counted from 0; --frame takes another)", input.frame, input.frames);
  if (!input.ignored.empty()) text += fmt::format("\nnot periodic, as asked for: {} is ignored", input.ignored);
  if (input.periodic) text += "\nperiodic: " + input.periodic->text;
  if (!input.units.empty())
    text += fmt::format("\nlengths are in {}, as the file's names say; nothing is converted", input.units);
  if (input.unread_momenta) text += "\nmomenta are not read: give velocities, momenta over masses, as velo:R:3";
  return text + "\n";
}

std::string describe_radii(const SphereFile& input) {
  const auto [low, high] = radius_range(input.scene);
  const std::string count = counted(input.scene.size(), "sphere");
  if (input.scene.size() == 0) return count + "\n";
  return fmt::format("{}, radius {}{}\n", count,
                     low == high ? fmt::format("{}", low) : fmt::format("{} to {}", low, high),
                     input.own_radii ? "" : " by --radius");
}

std::string describe_digits(const SphereFile& input) {
  if (input.scene.size() == 0) return "";
  std::string text = input.changed ? fmt::format("{} of {} {} more digits than float32 keeps\n", input.changed,
                                                 counted(input.values, "number"), input.changed == 1 ? "has" : "have")
                                   : fmt::format("float32 keeps every given digit of the {} numbers\n", input.values);
  const auto& [x, y, z] = input.rounding.shift;
  if (x != 0 || y != 0 || z != 0)
    text += fmt::format("centres shifted by ({}, {}, {}) before rounding, which changes no distance\n", 0 - x, 0 - y,
                        0 - z);
  return text;
}

std::string describe_rounding(const SphereFile& input) {
  if (input.rounding.largest == 0) return "";
  return fmt::format("rounding to float32 moves a {} by {} at most\n", input.ignores_radii ? "point" : "surface",
                     at_most(input.rounding.largest));
}

std::string describe(const SphereFile& input) {
  return describe_file(input) + box_warning(input) + describe_radii(input) + describe_digits(input) +
         describe_rounding(input);
}

json to_json(const SphereFile& input) {
  const auto [low, high] = radius_range(input.scene);
  return {{"file", input.file},
          {"format", input.format},
          {"frame", input.frame},
          {"frames", input.frames},
          {"n", input.scene.size()},
          {"radius_from", input.own_radii ? "file" : "option"},
          {"radii_not_used", input.unused_radii},
          {"smallest_radius", low},
          {"largest_radius", high},
          {"numbers", input.values},
          {"numbers_changed", input.changed},
          {"ignored", input.ignored},
          {"periodic", input.periodic ? input.periodic->text : ""},
          {"shift", input.rounding.shift},
          {"largest_rounding", input.rounding.largest}};
}

}  // namespace spherepair
