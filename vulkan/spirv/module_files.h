// SPDX-License-Identifier: MIT
// Keeps compiled kernels in files, so that a later process need not compile them again. A file is found by a 128-bit
// digest of the text and of glslang's version, and read only if it is whole.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace spherepair {

// Returns the SPIR-V of a text, as the folder has it. Otherwise calls compile() and writes the result to the folder, if
// it can. If `folder` is empty, nothing is read or written.
std::vector<uint32_t> kept_words(const std::filesystem::path& folder, const std::string& text,
                                 const std::function<std::vector<uint32_t>()>& compile);

}  // namespace spherepair
