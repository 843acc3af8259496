// SPDX-License-Identifier: MIT
#include "bench/output/pair_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "bench/npy/rows_file.h"

namespace spherepair {
namespace {

// A row of the structured array in the file.
struct [[gnu::packed]] ContactRow {
  uint32_t i, j;
  Contact contact;
};
static_assert(sizeof(ContactRow) == 64);

struct DistanceRow {
  uint32_t i, j;
  double distance;
};
static_assert(sizeof(DistanceRow) == 16);

template <typename Make>
void write_structured(const Sink& sink, const std::string& dtype, std::span<const Pair> pairs, Make make) {
  sink(npy_head(dtype, fmt::format("({},)", pairs.size())));
  std::vector<decltype(make(pairs[0]))> rows;
  for (size_t start = 0; start < pairs.size(); start += rows_at_a_time) {
    rows.clear();
    for (const Pair& pair : pairs.subspan(start, std::min(rows_at_a_time, pairs.size() - start)))
      rows.push_back(make(pair));
    sink(bytes_of(std::span<const decltype(make(pairs[0]))>(rows)));
  }
}

template <typename Number>
void write_array(const std::string& file, const char* dtype, std::span<const Number> numbers) {
  write_rows(file, 0, {}, [&](const Sink& sink) {
    sink(npy_head(dtype, fmt::format("({},)", numbers.size())));
    sink(bytes_of(numbers));
  });
}

}  // namespace

char separator_of_rows(const std::string& file) { return lower_extension(file) == ".csv" ? ',' : ' '; }

std::string names_line(const std::string& file, const std::vector<std::string>& names) {
  if (file == "-") return "";
  const char separator = separator_of_rows(file);
  return fmt::format("{}{}\n", separator == ',' ? "" : "# ", fmt::join(names, std::string(1, separator)));
}

void check_pair_file(const std::string& option, const std::string& file) {
  check_rows_file(option, file, {".npy", ".txt", ".csv"},
                  ".npy (NPY), .txt (text), .csv (CSV) and - (text to standard output)");
}

void write_pairs(const std::string& file, std::span<const Pair> pairs) {
  const char separator = separator_of_rows(file);
  const Rows rows = [&](fmt::memory_buffer& text, size_t first, size_t last) {
    for (const Pair& pair : pairs.subspan(first, last - first)) {
      text.append(fmt::format_int(pair.first));
      text.push_back(separator);
      text.append(fmt::format_int(pair.second));
      text.push_back('\n');
    }
  };
  const auto write_npy = [&](const Sink& sink) {
    sink(npy_head("'@u4'", fmt::format("({}, 2)", pairs.size())));
    sink(bytes_of(pairs));
  };
  write_rows(file, pairs.size(), rows, write_npy, names_line(file, {"i", "j"}));
}

void write_distances(const std::string& file, std::span<const Pair> pairs, std::span<const vec4> spheres) {
  const char s = separator_of_rows(file);
  const Rows rows = [&](fmt::memory_buffer& text, size_t first, size_t last) {
    for (const Pair& pair : pairs.subspan(first, last - first))
      fmt::format_to(std::back_inserter(text), "{}{}{}{}{}\n", pair.first, s, pair.second, s,
                     distance_of(pair, spheres));
  };
  const auto write_npy = [&](const Sink& sink) {
    write_structured(sink, "[('i', '@u4'), ('j', '@u4'), ('distance', '@f8')]", pairs, [&](const Pair& pair) {
      return DistanceRow{pair.first, pair.second, distance_of(pair, spheres)};
    });
  };
  write_rows(file, pairs.size(), rows, write_npy, names_line(file, {"i", "j", "distance"}));
}

void write_contacts(const std::string& file, std::span<const Pair> pairs, std::span<const vec4> spheres,
                    const std::array<double, 3>& shift) {
  const std::string s(1, separator_of_rows(file));
  const Rows rows = [&](fmt::memory_buffer& text, size_t first, size_t last) {
    for (const Pair& pair : pairs.subspan(first, last - first)) {
      const Contact c = contact_of(pair, spheres, shift);
      fmt::format_to(std::back_inserter(text), "{}{}{}{}{}{}{}{}{}\n", pair.first, s, pair.second, s, c.overlap, s,
                     fmt::join(c.normal, s), s, fmt::join(c.point, s));
    }
  };
  const auto write_npy = [&](const Sink& sink) {
    write_structured(
        sink, "[('i', '@u4'), ('j', '@u4'), ('overlap', '@f8'), ('normal', '@f8', (3,)), ('point', '@f8', (3,))]",
        pairs, [&](const Pair& pair) {
          return ContactRow{pair.first, pair.second, contact_of(pair, spheres, shift)};
        });
  };
  write_rows(file, pairs.size(), rows, write_npy,
             names_line(file, {"i", "j", "overlap", "nx", "ny", "nz", "px", "py", "pz"}));
}

void write_contact_numbers(const std::string& file, std::span<const uint> counts) {
  const Rows rows = [&](fmt::memory_buffer& text, size_t first, size_t last) {
    for (const uint count : counts.subspan(first, last - first)) {
      text.append(fmt::format_int(count));
      text.push_back('\n');
    }
  };
  const auto write_npy = [&](const Sink& sink) {
    sink(npy_head("'@u4'", fmt::format("({},)", counts.size())));
    sink(bytes_of(counts));
  };
  write_rows(file, counts.size(), rows, write_npy, names_line(file, {"contacts"}));
}

NeighbourFiles neighbour_files(const std::string& file, bool distances) {
  const std::string stem = file.substr(0, file.size() - std::string(".npy").size());
  return {stem + ".offsets.npy", stem + ".neighbours.npy", distances ? stem + ".distances.npy" : "",
          stem + ".shifts.npy"};
}

// `pairs` must be sorted. The first loop then writes each sphere's lower neighbours in ascending order, the second
// appends its higher ones.
void write_neighbours(const NeighbourFiles& files, std::span<const Pair> pairs, std::span<const uint> counts,
                      std::span<const vec4> spheres) {
  std::vector<uint64_t> offsets(counts.size() + 1, 0);
  std::inclusive_scan(counts.begin(), counts.end(), offsets.begin() + 1, std::plus<uint64_t>(), uint64_t(0));
  std::vector<uint64_t> next = offsets;
  std::vector<uint> neighbours(2 * pairs.size());
  for (const Pair& pair : pairs) neighbours[next[pair.second]++] = pair.first;
  for (const Pair& pair : pairs) neighbours[next[pair.first]++] = pair.second;
  write_array<uint64_t>(files.offsets, "'@u8'", offsets);
  write_array<uint>(files.neighbours, "'@u4'", neighbours);
  if (files.distances.empty()) return;
  std::vector<double> distances(neighbours.size());
  for (uint i = 0; i < counts.size(); ++i)
    for (uint64_t k = offsets[i]; k < offsets[i + 1]; ++k) distances[k] = distance_of({i, neighbours[k]}, spheres);
  write_array<double>(files.distances, "'@f8'", distances);
}

}  // namespace spherepair
