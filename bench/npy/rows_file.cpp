// SPDX-License-Identifier: MIT
#include "bench/npy/rows_file.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "common/files/replaced_file.h"

namespace spherepair {
namespace {

namespace fs = std::filesystem;

void write_text(size_t count, const Rows& rows, const std::string& head, const Sink& sink) {
  sink(head);
  fmt::memory_buffer text;
  for (size_t start = 0; start < count; start += rows_at_a_time) {
    text.clear();
    rows(text, start, std::min(start + rows_at_a_time, count));
    sink({text.data(), text.size()});
  }
}

void write_standard_output(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw std::invalid_argument(fmt::format("cannot write the rows to standard output: {}", std::strerror(errno)));
}

}  // namespace

std::string lower_extension(const std::string& file) {
  std::string extension = fs::path(file).extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

void check_rows_file(const std::string& option, const std::string& file, const std::vector<std::string>& extensions,
                     const std::string& known) {
  if (file.empty() || file == kStandardOutput) return;
  std::error_code error;
  const bool other = fs::exists(file, error) && !fs::is_regular_file(file, error);
  if (!other && std::ranges::find(extensions, lower_extension(file)) == extensions.end())
    throw std::invalid_argument(
        fmt::format("cannot tell the format of {} {} by its extension; known are {}", option, file, known));
}

// Pads the header with spaces, so that the data start at a multiple of 64 bytes.
std::string npy_head(std::string dtype, const std::string& shape) {
  std::ranges::replace(dtype, '@', std::endian::native == std::endian::little ? '<' : '>');
  std::string header = fmt::format("{{'descr': {}, 'fortran_order': False, 'shape': {}, }}", dtype, shape);
  constexpr size_t before = 10, alignment = 64;
  header.append((alignment - (before + header.size() + 1) % alignment) % alignment, ' ');
  header += '\n';
  return std::string("\x93NUMPY\x01\x00", 8) + char(header.size() % 256) + char(header.size() / 256) + header;
}

void write_rows(const std::string& file, size_t count, const Rows& rows,
                const std::function<void(const Sink&)>& write_binary, const std::string& head) {
  if (file == kStandardOutput) return write_text(count, rows, head, write_standard_output);
  ReplacedFile output(file);
  const Sink sink = [&](std::string_view bytes) { output.write(bytes); };
  const std::string extension = lower_extension(file);
  extension == ".npy" || extension == ".vtp" ? write_binary(sink) : write_text(count, rows, head, sink);
  output.commit();
}

}  // namespace spherepair
