// SPDX-License-Identifier: MIT
// In place of libFuzzer, which only clang has: every file of the folder named goes through the target once.
#include <cstdio>
#include <filesystem>

#include "tests/fuzz/fuzz.h"
#include "tests/support/sphere_files.h"

int main(int, char** argv) {
  int inputs = 0;
  for (const auto& entry : std::filesystem::directory_iterator(argv[1])) {
    const std::string bytes = spherepair::read_bytes(entry.path().string());
    LLVMFuzzerTestOneInput(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size());
    ++inputs;
  }
  std::printf("%d inputs\n", inputs);
  return inputs ? 0 : 1;
}
