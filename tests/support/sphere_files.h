// SPDX-License-Identifier: MIT
// Makes files of spheres for a test, in a folder that is removed with it.
#pragma once

#include <bit>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/spheres/sphere_file.h"

namespace spherepair {

class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string write(const std::string& name, const std::string& bytes) const;  // returns the path
  std::vector<std::string> names() const;                                      // of the files in it, sorted

 private:
  std::filesystem::path folder_;
};

std::string read_bytes(const std::string& file);

// The message of a failing action; empty if it does not throw std::invalid_argument.
template <typename Action>
std::string complaint_of(Action action) {
  try {
    action();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

// An NPY file of this header, padded like NumPy's, and data.
std::string npy_file(const std::string& header, const std::string& data, char version = 1);
std::string npy_header(const std::string& dtype, const std::string& shape, bool fortran_order = false);

// The numbers row by row as an array's data, in the given order of bytes and of axes.
template <typename Real>
std::string npy_data(const std::vector<Real>& values, size_t columns, bool big_endian = false,
                     bool fortran_order = false) {
  const size_t rows = values.size() / columns;
  std::string data;
  for (size_t k = 0; k < values.size(); ++k) {
    const Real value = fortran_order ? values[k % rows * columns + k / rows] : values[k];
    std::string bytes(sizeof value, 0);
    std::memcpy(bytes.data(), &value, sizeof value);
    if (big_endian != (std::endian::native == std::endian::big)) bytes.assign(bytes.rbegin(), bytes.rend());
    data += bytes;
  }
  return data;
}

}  // namespace spherepair
