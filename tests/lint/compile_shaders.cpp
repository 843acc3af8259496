// SPDX-License-Identifier: MIT
// compile_shaders FOLDER: compiles each NAME.comp in a folder as the program does for Vulkan, to NAME.spv, or writes
// what was wrong with it to NAME.txt.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <span>
#include <sstream>

#include "common/backend/backend.h"
#include "vulkan/spirv/compile.h"

namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

void compile(std::filesystem::path path) {
  try {
    const auto module = spherepair::compile_to_spirv(text_of(path), path.stem().string());
    const auto bytes = std::as_bytes(std::span(module.words()));
    std::ofstream(path.replace_extension(".spv"), std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  } catch (const spherepair::BackendError& error) {
    std::ofstream(path.replace_extension(".txt")) << error.what();
  }
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) {
    std::cerr << "usage: compile_shaders FOLDER\n";
    return 2;
  }
  for (const auto& entry : std::filesystem::directory_iterator(words[1]))
    if (entry.path().extension() == ".comp") compile(entry.path());
  return 0;
}
