// SPDX-License-Identifier: MIT
#include "bench/formats/files.h"

#include <fmt/format.h>

#include <stdexcept>

#include "bench/io/replaced_file.h"

namespace spherepair {

namespace fs = std::filesystem;

void write_file(const fs::path& path, const std::string& text) {
  ReplacedFile file(path);
  file.write(text);
  file.commit();
}

void prepare_folder(const fs::path& folder, const std::vector<std::string>& files) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw std::invalid_argument(
        fmt::format("cannot create the folder {}: {}; choose another", folder.string(), error.message()));
  for (const std::string& file : files) check_writable(folder / file);
}

}  // namespace spherepair
