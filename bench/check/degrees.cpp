// SPDX-License-Identifier: MIT
#include "bench/check/degrees.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace spherepair {
namespace {

constexpr uint kSingle = 16;  // smaller degrees have a bin each

// Spheres by degree.
std::vector<uint64_t> histogram(std::span<const uint> counts) {
  std::vector<uint64_t> spheres(counts.empty() ? 0 : size_t(std::ranges::max(counts)) + 1);
  for (uint count : counts) ++spheres[count];
  return spheres;
}

// The degree at this rank when the spheres are sorted by degree.
uint degree_at(const std::vector<uint64_t>& spheres, uint64_t rank) {
  uint degree = 0;
  for (uint64_t passed = spheres[0]; passed <= rank; passed += spheres[degree]) ++degree;
  return degree;
}

std::vector<DegreeBin> bins_of(const std::vector<uint64_t>& spheres, uint least) {
  std::vector<DegreeBin> bins;
  for (uint64_t from = least < kSingle ? least : std::bit_floor(least), to; from < spheres.size(); from = to + 1) {
    to = from < kSingle ? from : 2 * from - 1;
    DegreeBin& bin = bins.emplace_back(DegreeBin{uint(from), uint(to), 0});
    for (uint64_t degree = from; degree <= to && degree < spheres.size(); ++degree) bin.spheres += spheres[degree];
  }
  return bins;
}

}  // namespace

Degrees degrees_of(std::span<const uint> counts) {
  Degrees degrees;
  if (counts.empty()) return degrees;
  const std::vector<uint64_t> spheres = histogram(counts);
  const uint64_t n = counts.size();
  degrees.spheres = n;
  degrees.least = degree_at(spheres, 0);
  degrees.most = uint(spheres.size() - 1);
  degrees.median = (double(degree_at(spheres, (n - 1) / 2)) + double(degree_at(spheres, n / 2))) / 2;
  uint64_t sum = 0;
  for (uint64_t degree = 0; degree < spheres.size(); ++degree) sum += degree * spheres[degree];
  degrees.mean = double(sum) / double(n);
  degrees.bins = bins_of(spheres, degrees.least);
  return degrees;
}

Table degree_table(const Degrees& degrees) {
  Table table{"Contacts of a sphere", {{"", "contacts", ""}, {"", "spheres", ""}, {"", "share", "%"}}, {}, {}};
  for (const auto& [from, to, spheres] : degrees.bins)
    table.rows.push_back({from == to ? fmt::format("{}", from) : fmt::format("{}-{}", from, to),
                          fmt::format("{}", spheres),
                          fmt::format("{:.2f}", 100 * double(spheres) / double(degrees.spheres))});
  table.notes = {fmt::format("least {}, median {}, mean {}, most {}", degrees.least, degrees.median,
                             format_number(degrees.mean), degrees.most)};
  return table;
}

json to_json(const Degrees& degrees) {
  json bins = json::array();
  for (const auto& [from, to, spheres] : degrees.bins)
    bins.push_back({{"from", from}, {"to", to}, {"spheres", spheres}});
  return {{"min", degrees.least},
          {"median", degrees.median},
          {"mean", degrees.mean},
          {"max", degrees.most},
          {"spheres_by_degree", bins}};
}

}  // namespace spherepair
