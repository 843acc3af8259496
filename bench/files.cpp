// SPDX-License-Identifier: MIT
#include "files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "replaced_file.h"

namespace spherepair {
namespace {

namespace fs = std::filesystem;

// Decimal numbers to the nearest float32; "nan" and "inf" are read too, so that the scene's check can name them.
std::vector<float> numbers(const std::string& line, const std::string& where) {
  std::vector<float> values;
  std::istringstream words(line.substr(0, line.find('#')));
  for (std::string word; words >> word;) {
    char* end = nullptr;
    values.push_back(std::strtof(word.c_str(), &end));
    if (*end != 0) throw std::invalid_argument(fmt::format("{}: '{}' is not a number", where, word));
  }
  if (values.empty() || values.size() == 4 || values.size() == 7) return values;
  throw std::invalid_argument(
      fmt::format("{}: {} numbers, but a sphere has 4 (x y z radius) or 7 (and vx vy vz)", where, values.size()));
}

}  // namespace

void write_file(const fs::path& path, const std::string& text) {
  ReplacedFile file(path);
  file.write(text);
  file.commit();
}

void prepare_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw std::invalid_argument(fmt::format("cannot create the results folder {}: {}; choose another with --results",
                                            folder.string(), error.message()));
  const fs::path trial = folder / "results.json.new";
  std::ofstream file(trial);
  if (!file)
    throw std::invalid_argument(fmt::format("cannot write in the results folder {}: {}; choose another with --results",
                                            folder.string(), std::strerror(errno)));
  file.close();
  fs::remove(trial, error);
}

Scene read_spheres(const fs::path& path) {
  std::ifstream file(path);
  if (!file) throw std::invalid_argument(fmt::format("cannot read {}: {}", path.string(), std::strerror(errno)));
  Scene scene;
  scene.name = path.filename().string();
  uint64_t count = 0;
  for (std::string line; std::getline(file, line);) {
    const std::vector<float> v = numbers(line, fmt::format("{}, line {}", path.string(), ++count));
    if (v.empty()) continue;
    scene.positions.push_back({v[0], v[1], v[2], v[3]});
    scene.velocities.push_back(v.size() == 7 ? vec4{v[4], v[5], v[6], 0} : vec4{0, 0, 0, 0});
  }
  scene.equal_radii = std::ranges::all_of(
      scene.positions, [&](const vec4& p) { return float_bits(p.w) == float_bits(scene.positions.front().w); });
  return scene;
}

}  // namespace spherepair
