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

// Returns what compile() makes of a text: from a file of the folder, else by a call, whose result is then written
// there. A folder that cannot be written stays as it is. Empty folder: always by a call.
std::vector<uint32_t> kept_words(const std::filesystem::path& folder, const std::string& text,
                                 const std::function<std::vector<uint32_t>()>& compile);

}  // namespace spherepair
