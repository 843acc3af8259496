// SPDX-License-Identifier: MIT
#include "bench/output/pair_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/npy/rows_file.h"
#include "bench/output/pair_geometry.h"
#include "common/lists/pair_list.h"

namespace spherepair {
namespace {

template <typename Number, typename Value>
void write_array(const std::string& file, const char* dtype, const std::string& shape, size_t count, Value value) {
  std::vector<Number> numbers(count);
#pragma omp parallel for schedule(static) if (count > rows_at_a_time)
  for (size_t k = 0; k < count; ++k) numbers[k] = value(k);
  write_rows(file, 0, {}, [&](const Sink& sink) {
    sink(npy_head(dtype, shape));
    sink(bytes_of(std::span<const Number>(numbers)));
  });
}

bool has_shifts(const ListProblem& problem) { return !problem.boxes[0].is_open(); }

void write_structured(const Sink& sink, const ListProblem& problem, std::span<const ListedPair> list,
                      const PairColumns& columns) {
  std::string dtype = "[('i', '@u4'), ('j', '@u4')";
  if (has_shifts(problem)) dtype += ", ('shift', '@i4', (3,))";
  if (columns.distances) dtype += ", ('distance', '@f8')";
  if (columns.geometry) dtype += ", ('overlap', '@f8'), ('normal', '@f8', (3,)), ('point', '@f8', (3,))";
  sink(npy_head(dtype + "]", fmt::format("({},)", list.size())));
  const size_t bytes = 2 * sizeof(uint32_t) + has_shifts(problem) * sizeof(Shift) + columns.distances * sizeof(double) +
                       columns.geometry * sizeof(Contact);
  std::string rows;
  for (size_t start = 0; start < list.size(); start += rows_at_a_time) {
    const auto part = list.subspan(start, std::min(rows_at_a_time, list.size() - start));
    rows.resize(part.size() * bytes);
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < part.size(); ++k) {
      char* at = rows.data() + k * bytes;
      const auto add = [&](const auto& value) {
        at = std::copy_n(reinterpret_cast<const char*>(&value), sizeof value, at);
      };
      add(part[k].first), add(part[k].second);
      if (has_shifts(problem)) add(part[k].shift);
      if (columns.distances) add(distance_of(problem, part[k]));
      if (columns.geometry) add(contact_of(problem, part[k]));
    }
    sink(rows);
  }
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

void write_listed(const std::string& file, const ListProblem& problem, std::span<const ListedPair> list,
                  const PairColumns& columns) {
  if (!has_shifts(problem) && !columns.distances && !columns.geometry) {
    std::vector<Pair> pairs(list.size());
    std::ranges::transform(list, pairs.begin(), [](const ListedPair& pair) { return Pair{pair.first, pair.second}; });
    return write_pairs(file, pairs);
  }
  const std::string s(1, separator_of_rows(file));
  const Rows rows = [&](fmt::memory_buffer& text, size_t first, size_t last) {
    const auto to = std::back_inserter(text);
    for (const ListedPair& pair : list.subspan(first, last - first)) {
      fmt::format_to(to, "{}{}{}", pair.first, s, pair.second);
      if (has_shifts(problem)) fmt::format_to(to, "{}{}", s, fmt::join(pair.shift, s));
      if (columns.distances) fmt::format_to(to, "{}{}", s, distance_of(problem, pair));
      if (columns.geometry) {
        const Contact c = contact_of(problem, pair);
        fmt::format_to(to, "{}{}{}{}{}{}", s, c.overlap, s, fmt::join(c.normal, s), s, fmt::join(c.point, s));
      }
      text.push_back('\n');
    }
  };
  std::vector<std::string> names = {"i", "j"};
  if (has_shifts(problem)) names.insert(names.end(), {"sx", "sy", "sz"});
  if (columns.distances) names.push_back("distance");
  if (columns.geometry) names.insert(names.end(), {"overlap", "nx", "ny", "nz", "px", "py", "pz"});
  write_rows(
      file, list.size(), rows, [&](const Sink& sink) { write_structured(sink, problem, list, columns); },
      names_line(file, names));
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

void write_neighbours(const NeighbourFiles& files, const ListProblem& problem, const std::vector<ListedPair>& list) {
  const std::vector<int64_t> offsets = offsets_of(list, problem.set.size());
  const std::string rows = fmt::format("({},)", list.size());
  write_array<uint64_t>(files.offsets, "'@u8'", fmt::format("({},)", offsets.size()), offsets.size(),
                        [&](size_t k) { return uint64_t(offsets[k]); });
  write_array<uint32_t>(files.neighbours, "'@u4'", rows, list.size(), [&](size_t k) { return list[k].second; });
  if (has_shifts(problem))
    write_array<Shift>(files.shifts, "'@i4'", fmt::format("({}, 3)", list.size()), list.size(),
                       [&](size_t k) { return list[k].shift; });
  if (!files.distances.empty())
    write_array<double>(files.distances, "'@f8'", rows, list.size(),
                        [&](size_t k) { return distance_of(problem, list[k]); });
}

}  // namespace spherepair
