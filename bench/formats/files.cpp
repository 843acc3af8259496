// SPDX-License-Identifier: MIT
#include "bench/formats/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "bench/formats/sphere_file.h"
#include "bench/formats/xyz_columns.h"
#include "bench/io/context.h"
#include "bench/io/file_lines.h"
#include "bench/io/replaced_file.h"

namespace spherepair {
namespace {

namespace fs = std::filesystem;

// Empty for an empty or comment line.
std::vector<float> read_line(const FileBytes& file, uint64_t line, std::string_view text) {
  constexpr std::array columns = {"x", "y", "z", "radius", "vx", "vy", "vz"};
  std::vector<std::string_view> fields;
  split_fields(text.substr(0, text.find('#')), columns.size() + 1, fields);
  if (!fields.empty() && fields.size() != 4 && fields.size() != 7)
    file.fail_at_line(line, "4 columns (x y z radius) or 7 (and vx vy vz)",
                      fields.size() > 7 ? "more than 7" : fmt::to_string(fields.size()));
  std::vector<float> values;
  for (size_t k = 0; k < fields.size(); ++k)
    values.push_back(read_number(file, line, fields, k, columns[k], k == 3).rounded);
  return values;
}

}  // namespace

void write_json(const std::string& file, const json& record) {
  if (file == kStandardOutput)
    fmt::print("{}", json_text(record));
  else if (!file.empty())
    write_file(file, json_text(record));
}

void add_json_output(OutputFiles& files, const std::string& file) {
  if (file != kStandardOutput) files.write("--json", file);
}

void write_file(const fs::path& path, const std::string& text) {
  ReplacedFile file(path);
  file.write(text);
  file.commit();
}

fs::path prepare_results(const std::string& results, const std::vector<std::string>& files) {
  const fs::path folder = results.empty() ? default_results() : results;
  prepare_folder(folder, files);
  return folder;
}

void prepare_folder(const fs::path& folder, const std::vector<std::string>& files) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw std::invalid_argument(
        fmt::format("cannot create the folder {}: {}; choose another", folder.string(), error.message()));
  for (const std::string& file : files) check_writable(folder / file);
}

Scene read_spheres(const fs::path& path) {
  const FileBytes file(path);
  require_text(file);
  Scene scene;
  scene.name = path.filename().string();
  for (FileLines lines{file.bytes()}; !lines.at_end();) {
    const uint64_t line = lines.line;
    const std::vector<float> v = read_line(file, line, lines.next());
    if (v.empty()) continue;
    scene.positions.push_back({v[0], v[1], v[2], v[3]});
    scene.velocities.push_back(v.size() == 7 ? vec4{v[4], v[5], v[6], 0} : vec4{0, 0, 0, 0});
  }
  scene.equal_radii = std::ranges::all_of(
      scene.positions, [&](const vec4& p) { return float_bits(p.w) == float_bits(scene.positions.front().w); });
  return scene;
}

}  // namespace spherepair
