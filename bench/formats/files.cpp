// SPDX-License-Identifier: MIT
#include "bench/formats/files.h"

#include <fmt/format.h>

#include <stdexcept>

#include "bench/io/context.h"
#include "bench/io/interruption.h"
#include "common/files/replaced_file.h"

namespace spherepair {

namespace fs = std::filesystem;

void write_text(const std::string& file, const std::string& text) {
  if (file == kStandardOutput)
    fmt::print("{}", text);
  else if (!file.empty())
    write_file(file, text);
}

void write_json(const std::string& file, const json& record) {
  if (!file.empty()) write_text(file, json_text(record));
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
  try {
    make_folder(folder);
  } catch (const fs::filesystem_error& error) {
    throw std::invalid_argument(
        fmt::format("cannot create the folder {}: {}; choose another", folder.string(), error.code().message()));
  }
  for (const std::string& file : files) check_writable(folder / file);
}

}  // namespace spherepair
