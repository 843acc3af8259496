// SPDX-License-Identifier: MIT
// What a command reads and writes, told before its work: nothing that is read is written over, no file is written
// twice.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace spherepair {

// Files are named with the option that they come from, for the reader; an empty path stands for an option that was not
// given. Throws std::invalid_argument. What is no regular file (a pipe, /dev/null) may have several uses.
class OutputFiles {
 public:
  void read(const std::string& option, const std::filesystem::path& path);

  // Also checks that the file can be written. in_place: the option of an input that is read whole before this output
  // replaces it.
  void write(const std::string& option, const std::filesystem::path& path, const std::string& in_place = "");

 private:
  struct Use {
    std::string option;
    std::filesystem::path path;
    bool output;
  };
  std::map<std::string, Use> uses_;  // by what is equal for two names of one file
};

}  // namespace spherepair
