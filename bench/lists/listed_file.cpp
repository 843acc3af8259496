// SPDX-License-Identifier: MIT
#include "bench/lists/listed_file.h"

#include <fmt/format.h>

#include "bench/npy/rows_file.h"
#include "common/lists/pair_list.h"

namespace spherepair {
namespace {

struct [[gnu::packed]] Row {
  ListedPair pair;
  double distance;
};
static_assert(sizeof(ListedPair) == 20 && sizeof(Row) == 28);

double distance_of(const ListProblem& problem, const ListedPair& pair) {
  return length(displacement(problem, problem.boxes[0], pair));
}

template <typename Number, typename Value>
void write_array(const std::string& file, const char* dtype, const std::string& shape, size_t count, Value value) {
  std::vector<Number> numbers(count);
  for (size_t k = 0; k < count; ++k) numbers[k] = value(k);
  write_rows(file, 0, {}, [&](const Sink& sink) {
    sink(npy_head(dtype, shape));
    sink(bytes_of(std::span<const Number>(numbers)));
  });
}

void write_npy(const Sink& sink, const ListProblem& problem, std::span<const ListedPair> list, bool distances) {
  const std::string columns = "[('i', '@u4'), ('j', '@u4'), ('shift', '@i4', (3,))";
  sink(npy_head(columns + (distances ? ", ('distance', '@f8')]" : "]"), fmt::format("({},)", list.size())));
  if (!distances) return sink(bytes_of(list));
  std::vector<Row> rows;
  for (size_t start = 0; start < list.size(); start += rows_at_a_time) {
    rows.clear();
    for (const ListedPair& pair : list.subspan(start, std::min(rows_at_a_time, list.size() - start)))
      rows.push_back({pair, distance_of(problem, pair)});
    sink(bytes_of(std::span<const Row>(rows)));
  }
}

}  // namespace

void write_listed(const std::string& file, const ListProblem& problem, std::span<const ListedPair> list,
                  bool distances) {
  const std::string s(1, separator_of_rows(file));
  const Rows rows = [&](fmt::memory_buffer& text, size_t first, size_t last) {
    for (const ListedPair& pair : list.subspan(first, last - first)) {
      const auto to = std::back_inserter(text);
      fmt::format_to(to, "{}{}{}{}{}", pair.first, s, pair.second, s, fmt::join(pair.shift, s));
      if (distances) fmt::format_to(to, "{}{}", s, distance_of(problem, pair));
      text.push_back('\n');
    }
  };
  std::vector<std::string> names = {"i", "j", "sx", "sy", "sz"};
  if (distances) names.push_back("distance");
  write_rows(
      file, list.size(), rows, [&](const Sink& sink) { write_npy(sink, problem, list, distances); },
      names_line(file, names));
}

void write_listed_neighbours(const NeighbourFiles& files, const ListProblem& problem,
                             std::span<const ListedPair> list) {
  const std::vector<int64_t> offsets = offsets_of({list.begin(), list.end()}, problem.set.size());
  const std::string rows = fmt::format("({},)", list.size());
  write_array<uint64_t>(files.offsets, "'@u8'", fmt::format("({},)", offsets.size()), offsets.size(),
                        [&](size_t k) { return uint64_t(offsets[k]); });
  write_array<uint32_t>(files.neighbours, "'@u4'", rows, list.size(), [&](size_t k) { return list[k].second; });
  write_array<Shift>(files.shifts, "'@i4'", fmt::format("({}, 3)", list.size()), list.size(),
                     [&](size_t k) { return list[k].shift; });
  if (!files.distances.empty())
    write_array<double>(files.distances, "'@f8'", rows, list.size(),
                        [&](size_t k) { return distance_of(problem, list[k]); });
}

}  // namespace spherepair
