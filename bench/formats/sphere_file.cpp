// SPDX-License-Identifier: MIT
#include "bench/formats/sphere_file.h"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace spherepair {
namespace {

struct Format {
  const char* extension;
  SphereFile (*read)(const FileBytes&, const SphereFileOptions&);
};
constexpr Format formats[] = {{".xyz", read_xyz}, {".extxyz", read_xyz}, {".npy", read_npy}};

const Format* format_of(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  const auto found = std::ranges::find_if(formats, [&](const Format& format) { return extension == format.extension; });
  return found == std::end(formats) ? nullptr : found;
}

std::pair<float, float> radius_range(const Scene& scene) {
  if (scene.size() == 0) return {0, 0};
  const auto [low, high] = std::ranges::minmax_element(scene.positions, {}, &vec4::w);
  return {low->w, high->w};
}

// Throws for another extension, and for options that no format takes.
const Format& known_format(const std::string& file, const SphereFileOptions& options) {
  const Format* format = format_of(file);
  if (!format)
    throw std::invalid_argument(fmt::format(
        "cannot tell the format of {} by its extension; known are .xyz and .extxyz (XYZ, extended XYZ) and .npy (NPY)",
        file));
  if (options.radius && why_invalid(*options.radius, true))
    throw std::invalid_argument(
        fmt::format("--radius is {}, but must be finite and not negative", double(*options.radius)));
  if (options.species && format->read != read_xyz)
    throw std::invalid_argument(fmt::format("{} has no species: only XYZ files have", file));
  return *format;
}

void complete(SphereFile& input, const std::string& file) {
  input.file = file;
  Scene& scene = input.scene;
  scene.name = std::filesystem::path(file).filename().string();
  scene.velocities.resize(scene.size(), vec4{0, 0, 0, 0});
  scene.equal_radii = std::ranges::all_of(
      scene.positions, [&](const vec4& p) { return float_bits(p.w) == float_bits(scene.positions.front().w); });
}

}  // namespace

bool is_sphere_file(const std::string& file) { return format_of(file) != nullptr; }

SphereFile read_sphere_file(const std::string& file, const SphereFileOptions& options) {
  const Format& format = known_format(file, options);
  SphereFile input = format.read(FileBytes(file), options);
  complete(input, file);
  return input;
}

std::vector<SphereFile> read_sphere_frames(const std::string& file, const SphereFileOptions& options) {
  const Format& format = known_format(file, options);
  if (format.read != read_xyz)
    throw std::invalid_argument(fmt::format("{} has no frames: --frames draws those of an XYZ file", file));
  std::vector<SphereFile> frames = read_xyz_frames(FileBytes(file), options);
  for (SphereFile& each : frames) complete(each, file);
  return frames;
}

void check_radius(const FileBytes& file, bool own_radii, const SphereFileOptions& options) {
  if (own_radii && options.radius)
    throw std::invalid_argument(
        fmt::format("{} has a radius for each sphere and --radius gives one for all: leave --radius out, or the radii",
                    file.name()));
  if (!own_radii && !options.radius)
    throw std::invalid_argument(
        fmt::format("{} has no radii: give the radius of all spheres with --radius", file.name()));
}

int reading_threads(const SphereFileOptions& options) {
  return options.threads > 0 ? options.threads : omp_get_max_threads();
}

std::string describe(const SphereFile& input) {
  std::string text = fmt::format("{}: {}", input.file, input.format);
  if (input.frames > 1)
    text += fmt::format(", frame {} of {} (counted from 0; --frame takes another)", input.frame, input.frames);
  const auto [low, high] = radius_range(input.scene);
  text += fmt::format("\n{} spheres, radius {}", input.scene.size(),
                      low == high ? fmt::format("{}", low) : fmt::format("{} to {}", low, high));
  if (!input.own_radii) text += " by --radius";
  if (input.changed)
    return text + fmt::format("\n{} of {} numbers changed when rounded to float32\n", input.changed, input.values);
  return text + fmt::format("\nfloat32 represents all {} numbers of the file\n", input.values);
}

json to_json(const SphereFile& input) {
  const auto [low, high] = radius_range(input.scene);
  return {{"file", input.file},      {"format", input.format},
          {"frame", input.frame},    {"frames", input.frames},
          {"n", input.scene.size()}, {"radius_from", input.own_radii ? "file" : "option"},
          {"smallest_radius", low},  {"largest_radius", high},
          {"numbers", input.values}, {"numbers_changed", input.changed}};
}

}  // namespace spherepair
