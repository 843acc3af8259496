// SPDX-License-Identifier: MIT
#include "tests/support/program.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <cstdlib>

namespace spherepair {

Outcome run_shell(const std::string& command, const ScratchFolder& folder) {
  const std::string output = folder.path(".output"), errors = folder.path(".errors");
  const int status = std::system(fmt::format("( {} ) >'{}' 2>'{}'", command, output, errors).c_str());
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  const Outcome outcome{code, read_bytes(output), read_bytes(errors)};
  std::filesystem::remove(output);
  std::filesystem::remove(errors);
  return outcome;
}

void ProgramTest::SetUp() {
  if (!std::filesystem::exists(SPHEREPAIR_PROGRAM)) GTEST_SKIP() << "no " << SPHEREPAIR_PROGRAM << " here";
}

Outcome ProgramTest::run(const std::string& arguments, const std::string& before) const {
  return run_shell(fmt::format("{} '{}' {}", before, SPHEREPAIR_PROGRAM, arguments), folder_);
}

}  // namespace spherepair
