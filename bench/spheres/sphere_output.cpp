// SPDX-License-Identifier: MIT
#include "bench/spheres/sphere_output.h"

#include <algorithm>
#include <array>
#include <vector>

#include "bench/spheres/columns.h"
#include "bench/spheres/rows_file.h"

namespace spherepair {
namespace {

using Numbers = std::array<float, quantity_names.size()>;  // as they lie in an NPY row

Numbers numbers_of(const vec4& p, const vec4& v) { return {p.x, p.y, p.z, p.w, v.x, v.y, v.z}; }

struct TextFormat {
  std::string head, species;
  const char* separator;
};

TextFormat text_format(const std::string& extension, size_t count) {
  if (extension == ".xyz" || extension == ".extxyz")  // other programs want a species
    return {fmt::format("{}\nProperties=species:S:1:pos:R:3:radius:R:1:velo:R:3\n", count), "X ", " "};
  const char* separator = extension == ".csv" ? "," : extension == ".tsv" ? "\t" : " ";
  const bool names = extension == ".csv" || extension == ".tsv";
  return {fmt::format("{}{}\n", names ? "" : "# ", fmt::join(quantity_names, separator)), "", separator};
}

}  // namespace

void check_sphere_output(const std::string& option, const std::string& file) {
  check_rows_file(option, file, {".npy", ".xyz", ".extxyz", ".csv", ".tsv", ".txt", ".dat"},
                  ".npy (NPY), .xyz and .extxyz (extended XYZ), .csv, .tsv, .txt and .dat (columns of text) and - "
                  "(text to standard output)");
}

void write_spheres(const std::string& file, std::span<const vec4> positions, std::span<const vec4> velocities) {
  const TextFormat format = text_format(lower_extension(file), positions.size());
  const Rows rows = [&](fmt::memory_buffer& text, size_t first, size_t last) {
    for (size_t i = first; i < last; ++i)
      fmt::format_to(std::back_inserter(text), "{}{}\n", format.species,
                     fmt::join(numbers_of(positions[i], velocities[i]), format.separator));
  };
  const auto write_npy = [&](const Sink& sink) {
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
  write_rows(file, positions.size(), rows, write_npy, format.head);
}

}  // namespace spherepair
