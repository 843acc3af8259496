// SPDX-License-Identifier: MIT
#include "common/scene/known_name.h"

#include <fmt/format.h>

#include <algorithm>

namespace spherepair {
namespace {

// Returns the optimal string alignment distance: Levenshtein's edits plus swaps of neighbours.
size_t edits_between(const std::string& a, const std::string& b) {
  std::vector<std::vector<size_t>> edits(a.size() + 1, std::vector<size_t>(b.size() + 1));
  for (size_t i = 0; i <= a.size(); ++i)
    for (size_t j = 0; j <= b.size(); ++j) {
      size_t& here = edits[i][j];
      if (i == 0 || j == 0) {
        here = i + j;
        continue;
      }
      here = std::min({edits[i - 1][j] + 1, edits[i][j - 1] + 1, edits[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) here = std::min(here, edits[i - 2][j - 2] + 1);
    }
  return edits[a.size()][b.size()];
}

}  // namespace

std::string nearest_name(const std::string& name, const std::vector<std::string>& known) {
  constexpr size_t longest = 64;  // longest name that may be a misspelling
  if (name.empty() || name.size() > longest) return {};
  size_t least = name.size() / 3 + 1;
  std::string nearest;
  for (const std::string& one : known)
    if (const size_t edits = edits_between(name, one); edits < least) least = edits, nearest = one;
  if (!nearest.empty()) return nearest;
  const auto holds = [&](const std::string& one) { return one.find(name) != one.npos; };
  const auto found = std::ranges::find_if(known, holds);
  return found == known.end() ? std::string() : *found;
}

std::string unknown_name(const std::string& what, const std::string& name, const std::vector<std::string>& known) {
  const std::string nearest = nearest_name(name, known);
  return fmt::format("unknown {} '{}'; {} {}", what, name,
                     nearest.empty() ? "known are" : fmt::format("did you mean {}? Known are", nearest),
                     fmt::join(known, ", "));
}

}  // namespace spherepair
