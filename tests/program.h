// SPDX-License-Identifier: MIT
// The program as a user runs it, in a shell.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "sphere_files.h"

namespace spherepair {

struct Outcome {
  int code = -1;  // 128 + the number of the signal that ended it
  std::string output, errors;
};

// Runs a shell command; its standard output and error go through files of this folder.
Outcome run_shell(const std::string& command, const ScratchFolder& folder);

// Skips where the tests were carried to another machine without the program.
class ProgramTest : public testing::Test {
 protected:
  void SetUp() override;

  // Arguments are words of a shell. `before` stands before the program: "ulimit -v 200000;", "timeout 60".
  Outcome run(const std::string& arguments, const std::string& before = "") const;
  std::string path(const std::string& name) const { return folder_.path(name); }
  nlohmann::json read_json(const std::string& name) const { return nlohmann::json::parse(read_bytes(path(name))); }

  const ScratchFolder folder_;
};

}  // namespace spherepair
