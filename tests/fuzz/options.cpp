// SPDX-License-Identifier: MIT
// The command line, a word a line: parsed, but the subcommand does not run.
#include <iostream>
#include <sstream>
#include <vector>

#include "api/open.h"
#include "bench/cli/command_line.h"
#include "tests/fuzz/fuzz.h"

using namespace spherepair;

FUZZ(options) {
  std::cout.setstate(std::ios::badbit);  // help and complaints
  std::cerr.setstate(std::ios::badbit);
  std::vector<std::string> words = {"spherepair"};
  std::istringstream lines{std::string(text_of(data, size))};
  for (std::string word; std::getline(lines, word);) words.push_back(word.c_str());
  std::vector<const char*> arguments;
  for (const std::string& word : words) arguments.push_back(word.c_str());
  run_program(int(arguments.size()), arguments.data(), open_backend, [](const std::function<int()>&) { return 0; });
}
