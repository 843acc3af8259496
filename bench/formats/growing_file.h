// SPDX-License-Identifier: MIT
// A file that a run writes while it moves.
#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace spherepair {

// The first text replaces the file; each further one is appended at once and stays, however the run ends. Pipes,
// devices and standard output get each text at once, too. An empty name writes nothing. Throws std::invalid_argument.
class GrowingFile {
 public:
  explicit GrowingFile(std::string name) : name_(std::move(name)) {}
  ~GrowingFile();
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  void add(std::string_view text);

 private:
  void open(std::string_view first);

  std::string name_;
  int descriptor_ = -1;
};

}  // namespace spherepair
