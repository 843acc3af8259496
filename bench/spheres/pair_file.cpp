// SPDX-License-Identifier: MIT
#include "bench/spheres/pair_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <stdexcept>

#include "bench/io/replaced_file.h"

namespace spherepair {
namespace {

namespace fs = std::filesystem;
using Sink = std::function<void(std::string_view)>;

constexpr size_t chunk = 65536;  // rows that are formatted at a time

std::string extension_of(const std::string& file) {
  std::string extension = fs::path(file).extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

// Rows from `first` to `last` as text.
using Rows = std::function<void(fmt::memory_buffer& text, size_t first, size_t last)>;

void write_text(size_t count, const Rows& rows, const Sink& sink) {
  fmt::memory_buffer text;
  for (size_t start = 0; start < count; start += chunk) {
    text.clear();
    rows(text, start, std::min(start + chunk, count));
    sink({text.data(), text.size()});
  }
}

// NPY version 1.0: the header is padded with spaces so that the data start at a multiple of 64 bytes. The dtype's @
// stands for the byte order.
std::string npy_header(std::string dtype, const std::string& shape) {
  std::ranges::replace(dtype, '@', std::endian::native == std::endian::little ? '<' : '>');
  std::string header = fmt::format("{{'descr': {}, 'fortran_order': False, 'shape': {}, }}", dtype, shape);
  constexpr size_t before = 10, alignment = 64;
  header.append((alignment - (before + header.size() + 1) % alignment) % alignment, ' ');
  header += '\n';
  return std::string("\x93NUMPY\x01\x00", 8) + char(header.size() % 256) + char(header.size() / 256) + header;
}

void write_standard_output(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw std::invalid_argument(fmt::format("cannot write the pairs to standard output: {}", std::strerror(errno)));
}

// Text, or what write_npy writes into the file.
void write(const std::string& file, size_t count, const Rows& rows, const std::function<void(const Sink&)>& write_npy) {
  if (file == kStandardOutput) return write_text(count, rows, write_standard_output);
  ReplacedFile output(file);
  const Sink sink = [&](std::string_view bytes) { output.write(bytes); };
  extension_of(file) == ".npy" ? write_npy(sink) : write_text(count, rows, sink);
  output.commit();
}

template <typename Number>
std::string_view bytes_of(std::span<const Number> numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()};
}

// As the structured array's rows lie in the file.
struct [[gnu::packed]] ContactRow {
  uint32_t i, j;
  Contact contact;
};
static_assert(sizeof(ContactRow) == 64);

}  // namespace

void check_pair_file(const std::string& option, const std::string& file) {
  if (file.empty() || file == kStandardOutput) return;
  const std::string extension = extension_of(file);
  std::error_code error;
  const bool other = fs::exists(file, error) && !fs::is_regular_file(file, error);
  if (extension != ".npy" && extension != ".txt" && !other)
    throw std::invalid_argument(
        fmt::format("cannot tell the format of {} {} by its extension; known are .npy (NPY), .txt (text) and - (text "
                    "to standard output)",
                    option, file));
}

void write_pairs(const std::string& file, std::span<const Pair> pairs) {
  const auto rows = [&](fmt::memory_buffer& text, size_t first, size_t last) {
    for (const Pair& pair : pairs.subspan(first, last - first)) {
      text.append(fmt::format_int(pair.first));
      text.push_back(' ');
      text.append(fmt::format_int(pair.second));
      text.push_back('\n');
    }
  };
  write(file, pairs.size(), rows, [&](const Sink& sink) {
    sink(npy_header("'@u4'", fmt::format("({}, 2)", pairs.size())));
    sink(bytes_of(pairs));
  });
}

Contact contact_of(const Pair& pair, std::span<const vec4> spheres, const std::array<double, 3>& shift) {
  const vec4 &a = spheres[pair.first], &b = spheres[pair.second];
  const double dx = double(b.x) - a.x, dy = double(b.y) - a.y, dz = double(b.z) - a.z;
  const double distance = std::hypot(dx, dy, dz);
  Contact contact{.overlap = double(a.w) + b.w - distance, .normal = {}, .point = {}};
  if (distance > 0) contact.normal = {dx / distance, dy / distance, dz / distance};
  const double along = a.w - contact.overlap / 2;
  contact.point = {a.x + along * contact.normal[0] + shift[0], a.y + along * contact.normal[1] + shift[1],
                   a.z + along * contact.normal[2] + shift[2]};
  return contact;
}

void write_contacts(const std::string& file, std::span<const Pair> pairs, std::span<const vec4> spheres,
                    const std::array<double, 3>& shift) {
  const auto rows = [&](fmt::memory_buffer& text, size_t first, size_t last) {
    for (const Pair& pair : pairs.subspan(first, last - first)) {
      const Contact c = contact_of(pair, spheres, shift);
      fmt::format_to(std::back_inserter(text), "{} {} {} {} {}\n", pair.first, pair.second, c.overlap,
                     fmt::join(c.normal, " "), fmt::join(c.point, " "));
    }
  };
  write(file, pairs.size(), rows, [&](const Sink& sink) {
    sink(npy_header("[('i', '@u4'), ('j', '@u4'), ('overlap', '@f8'), ('normal', '@f8', (3,)), ('point', '@f8', (3,))]",
                    fmt::format("({},)", pairs.size())));
    std::vector<ContactRow> packed;
    for (size_t start = 0; start < pairs.size(); start += chunk) {
      packed.clear();
      for (const Pair& pair : pairs.subspan(start, std::min(chunk, pairs.size() - start)))
        packed.push_back({pair.first, pair.second, contact_of(pair, spheres, shift)});
      sink(bytes_of(std::span<const ContactRow>(packed)));
    }
  });
}

void write_contact_numbers(const std::string& file, std::span<const uint> counts) {
  const auto rows = [&](fmt::memory_buffer& text, size_t first, size_t last) {
    for (const uint count : counts.subspan(first, last - first)) {
      text.append(fmt::format_int(count));
      text.push_back('\n');
    }
  };
  write(file, counts.size(), rows, [&](const Sink& sink) {
    sink(npy_header("'@u4'", fmt::format("({},)", counts.size())));
    sink(bytes_of(counts));
  });
}

}  // namespace spherepair
