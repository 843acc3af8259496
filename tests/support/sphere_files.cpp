// SPDX-License-Identifier: MIT
#include "tests/support/sphere_files.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace spherepair {
namespace {

namespace fs = std::filesystem;

// In the build folder, or where that is not (on another machine) in the system's.
fs::path scratch_root() {
  std::error_code error;
  fs::create_directories(SPHEREPAIR_SCRATCH, error);
  return error ? fs::temp_directory_path() : fs::path(SPHEREPAIR_SCRATCH);
}

}  // namespace

ScratchFolder::ScratchFolder() {
  static int made = 0;
  folder_ = scratch_root() / ("spherepair-" + std::to_string(getpid()) + "-" + std::to_string(made++));
  fs::create_directories(folder_);
}

ScratchFolder::~ScratchFolder() {
  std::error_code error;
  fs::remove_all(folder_, error);
}

std::string ScratchFolder::write(const std::string& name, const std::string& bytes) const {
  std::ofstream(folder_ / name, std::ios::binary) << bytes;
  return path(name);
}

std::vector<std::string> ScratchFolder::names() const {
  std::vector<std::string> found;
  for (const auto& entry : fs::directory_iterator(folder_)) found.push_back(entry.path().filename().string());
  std::ranges::sort(found);
  return found;
}

std::string read_bytes(const std::string& file) {
  std::ostringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  return bytes.str();
}

std::string npy_header(const std::string& dtype, const std::string& shape, bool fortran_order) {
  return "{'descr': '" + dtype + "', 'fortran_order': " + (fortran_order ? "True" : "False") + ", 'shape': " + shape +
         ", }";
}

std::string npy_file(const std::string& header, const std::string& data, char version) {
  const size_t width = version == 1 ? 2 : 4, before = 8 + width;
  std::string padded = header;
  padded.append((64 - (before + header.size() + 1) % 64) % 64, ' ');
  padded += '\n';
  std::string file = std::string("\x93NUMPY") + version + '\0';
  for (size_t k = 0; k < width; ++k) file += char(padded.size() >> 8 * k & 255);
  return file + padded + data;
}

}  // namespace spherepair
