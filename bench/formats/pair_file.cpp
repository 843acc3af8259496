// SPDX-License-Identifier: MIT
#include "bench/formats/pair_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <stdexcept>

#include "bench/io/replaced_file.h"

namespace spherepair {
namespace {

using Sink = std::function<void(std::string_view)>;

std::string extension_of(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

void write_text(std::span<const Pair> pairs, const Sink& sink) {
  constexpr size_t chunk = 65536;
  fmt::memory_buffer text;
  for (size_t start = 0; start < pairs.size(); start += chunk) {
    text.clear();
    for (const Pair& pair : pairs.subspan(start, std::min(chunk, pairs.size() - start))) {
      text.append(fmt::format_int(pair.first));
      text.push_back(' ');
      text.append(fmt::format_int(pair.second));
      text.push_back('\n');
    }
    sink({text.data(), text.size()});
  }
}

// NPY version 1.0: the header is padded with spaces so that the data start at a multiple of 64 bytes.
void write_npy(std::span<const Pair> pairs, const Sink& sink) {
  const char order = std::endian::native == std::endian::little ? '<' : '>';
  std::string header =
      fmt::format("{{'descr': '{}u4', 'fortran_order': False, 'shape': ({}, 2), }}", order, pairs.size());
  constexpr size_t before = 10, alignment = 64;
  header.append((alignment - (before + header.size() + 1) % alignment) % alignment, ' ');
  header += '\n';
  sink(std::string("\x93NUMPY\x01\x00", 8) + char(header.size() % 256) + char(header.size() / 256) + header);
  sink({reinterpret_cast<const char*>(pairs.data()), pairs.size_bytes()});
}

void write_standard_output(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw std::invalid_argument(fmt::format("cannot write the pairs to standard output: {}", std::strerror(errno)));
}

}  // namespace

void check_pair_file(const std::string& file) {
  if (file == kStandardOutput) return;
  const std::string extension = extension_of(file);
  if (extension != ".npy" && extension != ".txt")
    throw std::invalid_argument(fmt::format(
        "cannot tell the format of {} by its extension; known are .npy (NPY), .txt (text) and - (text to standard "
        "output)",
        file));
}

void write_pairs(const std::string& file, std::span<const Pair> pairs) {
  if (file == kStandardOutput) return write_text(pairs, write_standard_output);
  ReplacedFile output(file);
  const Sink sink = [&](std::string_view bytes) { output.write(bytes); };
  extension_of(file) == ".npy" ? write_npy(pairs, sink) : write_text(pairs, sink);
  output.commit();
}

}  // namespace spherepair
