// SPDX-License-Identifier: MIT
#include "bench/output/sphere_output.h"

#include <algorithm>
#include <array>
#include <vector>

#include "bench/npy/rows_file.h"
#include "bench/spheres/columns.h"

namespace spherepair {
namespace {

using Numbers = std::array<float, quantity_names.size()>;  // in the order of an NPY row

Numbers numbers_of(const vec4& p, const vec4& v) { return {p.x, p.y, p.z, p.w, v.x, v.y, v.z}; }

constexpr const char* species = "X ";  // which other programs require

struct TextFormat {
  std::string head, species;
  const char* separator;
};

// The box as Origin and Lattice. Edges are differences in float64: added to the origin and rounded to float32 they give
// the corners again.
std::string text_of(const std::optional<WallBox>& box) {
  if (!box) return "";
  const auto edge = [&](size_t axis) { return double(box->high[axis]) - double(box->low[axis]); };
  const auto repeats = [&](uint axis) { return box->periodic >> axis & 1 ? "T" : "F"; };
  return fmt::format(" Lattice=\"{} 0 0 0 {} 0 0 0 {}\" Origin=\"{}\" pbc=\"{} {} {}\"", edge(0), edge(1), edge(2),
                     fmt::join(box->low, " "), repeats(0), repeats(1), repeats(2));
}

std::string xyz_head(size_t count, const std::optional<WallBox>& box, const std::string& keys) {
  return fmt::format("{}\nProperties=species:S:1:pos:R:3:radius:R:1:velo:R:3{}{}\n", count, text_of(box), keys);
}

TextFormat text_format(const std::string& extension, size_t count, const std::optional<WallBox>& box) {
  if (extension == ".xyz" || extension == ".extxyz") return {xyz_head(count, box, ""), species, " "};
  const char* separator = extension == ".csv" ? "," : extension == ".tsv" ? "\t" : " ";
  const bool names = extension == ".csv" || extension == ".tsv";
  return {fmt::format("{}{}\n", names ? "" : "# ", fmt::join(quantity_names, separator)), "", separator};
}

Rows rows_of(const TextFormat& format, std::span<const vec4> positions, std::span<const vec4> velocities) {
  return [&format, positions, velocities](fmt::memory_buffer& text, size_t first, size_t last) {
    for (size_t i = first; i < last; ++i)
      fmt::format_to(std::back_inserter(text), "{}{}\n", format.species,
                     fmt::join(numbers_of(positions[i], velocities[i]), format.separator));
  };
}

}  // namespace

void check_sphere_output(const std::string& option, const std::string& file) {
  check_rows_file(
      option, file, {".npy", ".vtp", ".xyz", ".extxyz", ".csv", ".tsv", ".txt", ".dat"},
      ".npy (NPY), .vtp (VTK PolyData), .xyz and .extxyz (extended XYZ), .csv, .tsv, .txt and .dat (columns "
      "of text) and - (text to standard output)");
}

void write_spheres(const std::string& file, std::span<const vec4> positions, std::span<const vec4> velocities,
                   const std::optional<WallBox>& box) {
  const TextFormat format = text_format(lower_extension(file), positions.size(), box);
  const Rows rows = rows_of(format, positions, velocities);
  const auto write_binary = [&](const Sink& sink) {
    if (lower_extension(file) == ".vtp") return write_vtp(sink, positions, velocities);
    sink(npy_head("[('pos', '@f4', (3,)), ('radius', '@f4'), ('velo', '@f4', (3,))]",
                  fmt::format("({},)", positions.size())));
    std::vector<Numbers> packed;
    for (size_t start = 0; start < positions.size(); start += rows_at_a_time) {
      packed.clear();
      for (size_t i = start; i < std::min(start + rows_at_a_time, positions.size()); ++i)
        packed.push_back(numbers_of(positions[i], velocities[i]));
      sink(bytes_of(std::span<const Numbers>(packed)));
    }
  };
  write_rows(file, positions.size(), rows, write_binary, format.head);
}

std::string xyz_frame(std::span<const vec4> positions, std::span<const vec4> velocities,
                      const std::optional<WallBox>& box, const std::string& keys) {
  const TextFormat format{xyz_head(positions.size(), box, keys), species, " "};
  fmt::memory_buffer text;
  text.append(format.head);
  rows_of(format, positions, velocities)(text, 0, positions.size());
  return fmt::to_string(text);
}

void check_xyz_output(const std::string& option, const std::string& file) {
  check_rows_file(option, file, {".xyz", ".extxyz"}, ".xyz and .extxyz (extended XYZ) and - (to standard output)");
}

}  // namespace spherepair
