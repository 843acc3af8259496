// SPDX-License-Identifier: MIT
#include "bench/spheres/sphere_file.h"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "bench/spheres/sphere_formats.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

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
  const SphereFormat& format = format_of(file, options);
  SphereFile input = format.open ? read_frame(file, *format.open(file, options), options.frame.value_or(0), rows)
                                 : format.read(file, options, rows);
  if (options.ignore_periodic && input.ignored.empty())
    throw std::invalid_argument(fmt::format("{} has no periodic box: omit --ignore-periodic", file.name()));
  return input;
}

void complete(SphereFile& input, SphereRows& rows, const FileBytes& bytes, const SphereFileOptions& options) {
  input.file = bytes.name();
  input.at_rest = std::ranges::all_of(rows.velocities, [](const vec4& v) { return v.x == 0 && v.y == 0 && v.z == 0; });
  if (options.exact) {
    input.given.set = std::move(rows.exact);
    input.given.set.offsets = {0, input.given.set.size()};
    input.given.boxes.resize(1);  // open unless read
    input.changed = 0;
    return;
  }
  input.largest_rounding = largest_rounding(rows);
  Scene& scene = input.scene;
  scene.name = std::filesystem::path(bytes.name()).filename().string();
  scene.positions = std::move(rows.positions);
  scene.velocities = std::move(rows.velocities);
  scene.velocities.resize(scene.size(), vec4{0, 0, 0, 0});
  scene.equal_radii = std::ranges::all_of(
      scene.positions, [&](const vec4& p) { return float_bits(p.w) == float_bits(scene.positions.front().w); });
}

// Gives all frames the same list of species.
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
  const SphereFormat& format = format_of(bytes, options);
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

int reading_threads(const SphereFileOptions& options) {
  return options.threads > 0 ? options.threads : omp_get_max_threads();
}

}  // namespace spherepair
