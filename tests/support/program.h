// SPDX-License-Identifier: MIT
// Runs the program in a shell, as a user does.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/sphere_files.h"

namespace spherepair {

// AddressSanitizer needs more address space than a limit on it would leave.
#ifdef __has_feature
constexpr bool limits_address_space = !__has_feature(address_sanitizer);
#elif defined(__SANITIZE_ADDRESS__)
constexpr bool limits_address_space = false;
#else
constexpr bool limits_address_space = true;
#endif
#define SKIP_WHERE_ADDRESS_SPACE_HAS_NO_LIMIT() \
  if (!limits_address_space) GTEST_SKIP() << "the address sanitizer needs more address space than the limit leaves"

struct Outcome {
  int code = -1;  // 128 + the number of the signal that ended it
  std::string output, errors;
};

// Runs a shell command; its standard output and error go through files in this folder.
Outcome run_shell(const std::string& command, const ScratchFolder& folder);

// Tests of the program; skipped on a machine to which only the tests were copied.
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
