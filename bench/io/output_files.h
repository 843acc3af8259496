// SPDX-License-Identifier: MIT
// Checks the files of a command before its work: no input is overwritten, no output is written twice.
#pragma once

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace spherepair {

// `-` as an output file means standard output, which only one output may use; a report then goes to standard error.
inline constexpr const char* kStandardOutput = "-";
inline bool is_standard_output(const std::vector<std::string>& files) {
  return std::ranges::find(files, kStandardOutput) != files.end();
}

// `option` names the file in messages; an empty path means that the option was not given. Throws std::invalid_argument.
// Files that are not regular (a pipe, /dev/null) may have several uses.
class OutputFiles {
 public:
  void read(const std::string& option, const std::filesystem::path& path);

  // Also checks that the file can be written. in_place: the option of an input that is read completely before this
  // output replaces it, so that both may be the same file.
  void write(const std::string& option, const std::filesystem::path& path, const std::string& in_place = "");

 private:
  struct Use {
    std::string option;
    std::filesystem::path path;
    bool output;
  };
  std::map<std::string, Use> uses_;  // by identity()
};

}  // namespace spherepair
