// SPDX-License-Identifier: MIT
#include "vulkan/spirv/module_files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>

#include "common/shared/hash.h"

namespace spherepair {
namespace {

namespace fs = std::filesystem;
using Digest = std::array<uint64_t, 2>;

Digest digest_of(std::string_view bytes) {
  Digest digest = {splitmix64(bytes.size()), murmur64(bytes.size() + 1)};
  for (size_t at = 0; at < bytes.size(); at += sizeof(uint64_t)) {
    uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, std::min(sizeof word, bytes.size() - at));
    digest = {splitmix64(digest[0] ^ word), murmur64(digest[1] ^ word)};
  }
  return digest;
}

// A file has the digest of its words, then the words. Returns nothing if it is missing or damaged.
std::vector<uint32_t> words_in(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(file)), {});
  Digest written;
  if (bytes.size() <= sizeof written) return {};
  std::memcpy(&written, bytes.data(), sizeof written);
  const std::string_view code = std::string_view(bytes).substr(sizeof written);
  if (digest_of(code) != written || code.size() % sizeof(uint32_t) != 0) return {};
  std::vector<uint32_t> words(code.size() / sizeof(uint32_t));
  std::memcpy(words.data(), code.data(), code.size());
  return words;
}

// Writes another file and renames it, since other processes may read and write this one.
void write_words(const fs::path& path, const std::vector<uint32_t>& words) {
  const std::string_view code(reinterpret_cast<const char*>(words.data()), words.size() * sizeof(uint32_t));
  const Digest digest = digest_of(code);
  std::error_code failed;
  fs::create_directories(path.parent_path(), failed);
  std::string temporary = path.string() + ".XXXXXX";
  const int descriptor = ::mkstemp(temporary.data());
  if (descriptor < 0) return;
  ::close(descriptor);
  std::ofstream file(temporary, std::ios::binary);
  file.write(reinterpret_cast<const char*>(digest.data()), sizeof digest)
      .write(code.data(), std::streamsize(code.size()));
  file.close();
  if (file) fs::rename(temporary, path, failed);
  if (!file || failed) fs::remove(temporary, failed);
}

}  // namespace

std::vector<uint32_t> kept_words(const fs::path& folder, const std::string& text,
                                 const std::function<std::vector<uint32_t>()>& compile) {
  if (folder.empty()) return compile();
  const Digest digest = digest_of(text);
  const fs::path path = folder / fmt::format("{:016x}{:016x}.spv", digest[0], digest[1]);
  std::vector<uint32_t> words = words_in(path);
  if (words.empty()) write_words(path, words = compile());
  return words;
}

}  // namespace spherepair
