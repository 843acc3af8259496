// SPDX-License-Identifier: MIT
#include "bench/text/known_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "bench/text/fields.h"

namespace spherepair {
namespace {

constexpr KnownName known_names[] = {{"x", QUANTITY_X},
                                     {"y", QUANTITY_Y},
                                     {"z", QUANTITY_Z},
                                     {"radius", QUANTITY_RADIUS},
                                     {"radii", QUANTITY_RADIUS},
                                     {"r", QUANTITY_RADIUS},
                                     {"vx", QUANTITY_VX},
                                     {"vy", QUANTITY_VY},
                                     {"vz", QUANTITY_VZ},
                                     {"pos", QUANTITY_X, 3},
                                     {"position", QUANTITY_X, 3},
                                     {"positions", QUANTITY_X, 3},
                                     {"centers", QUANTITY_X, 3},
                                     {"centres", QUANTITY_X, 3},
                                     {"velo", QUANTITY_VX, 3},
                                     {"vel", QUANTITY_VX, 3},
                                     {"velocity", QUANTITY_VX, 3},
                                     {"velocities", QUANTITY_VX, 3},
                                     {"diameter", QUANTITY_RADIUS},
                                     {"diameters", QUANTITY_RADIUS}};

// Whether a text in brackets is a unit: not only digits, as in x[0], nor words, as in x (first axis).
bool is_unit(std::string_view text) {
  const auto all = [&](auto wanted) { return std::ranges::all_of(text, wanted); };
  const bool words = text.find(' ') != text.npos &&
                     all([](char c) { return c == ' ' || std::isalpha(static_cast<unsigned char>(c)); });
  return !words && !all([](char c) { return c == ' ' || (c >= '0' && c <= '9'); });
}

// Splits `X [mm]` or `x(mm)` into name and unit.
PlainName split_name(std::string_view text) {
  text = trimmed(text);
  const size_t open = text.find_first_of("[(");
  const bool closed = text.ends_with(']') || text.ends_with(')');
  if (open == text.npos || open == 0 || !closed) return {std::string(text), ""};
  const std::string_view unit = trimmed(text.substr(open + 1, text.size() - open - 2));
  return {std::string(trimmed(text.substr(0, open))), std::string(is_unit(unit) ? unit : "")};
}

// Prefers three components to one, then the earlier known name, then lower case.
bool is_better(const Candidate& one, const Candidate& other) {
  if (one.known->count != other.known->count)
    return one.known->count > 1 && other.known->first >= one.known->first &&
           other.known->first < one.known->first + one.known->count;
  if (one.known != other.known)
    return one.known->count > 1 && one.known->first == other.known->first && one.known < other.known;
  return one.same_case && !other.same_case;
}

}  // namespace

PlainName plain_name(std::string_view text) {
  const PlainName name = split_name(text);
  return {lower_case(name.name), name.unit};
}

const KnownName* known_name(std::string_view name) {
  const auto known = std::ranges::find(known_names, plain_name(name).name, &KnownName::name);
  return known == std::end(known_names) ? nullptr : known;
}

std::vector<Candidate> candidates_of(std::span<const NamedColumn> names) {
  std::vector<std::string> plain;
  for (const NamedColumn& column : names) plain.push_back(plain_name(column.name).name);
  const auto beside = [&](const char* name) { return std::ranges::count(plain, name) > 0; };
  const bool r_is_radius = !(beside("g") && beside("b")) && !beside("theta") && !beside("phi");
  std::vector<Candidate> all, best;
  size_t at = 0;
  for (size_t k = 0; k < names.size(); at += names[k++].count) {
    const KnownName* known = known_name(names[k].name);
    if (known && known->count == names[k].count && (plain[k] != "r" || r_is_radius))
      all.push_back(
          {names[k], known, at, split_name(names[k].name).name == known->name, known->name.starts_with("diameter")});
  }
  for (const Candidate& one : all)
    if (std::ranges::none_of(all, [&](const Candidate& other) { return is_better(other, one); })) best.push_back(one);
  return best;
}

std::string advice(const Columns& columns, std::span<const Candidate> candidates) {
  if (columns.count > 40) return "; give --columns with a quantity, or _, for each column in their order";
  std::vector<std::string_view> words(columns.count, "_");
  if (columns.species) words[*columns.species] = "species";
  std::array<std::optional<size_t>, quantity_names.size()> first;
  for (const Candidate& one : candidates)
    for (size_t c = 0; c < one.known->count; ++c)
      if (!first[one.known->first + c]) {
        first[one.known->first + c] = one.at + c;
        words[one.at + c] = one.diameters ? "diameter" : quantity_names[one.known->first + c];
      }
  if (!first[QUANTITY_X] || !first[QUANTITY_Y] || !first[QUANTITY_Z]) return "";
  const auto velocities = std::span(first).subspan(QUANTITY_VX);
  if (!std::ranges::all_of(velocities, [](const auto& at) { return at.has_value(); }))
    for (const auto& at : velocities)
      if (at) words[*at] = "_";
  return fmt::format("; name them in their order, such as --columns {}", fmt::join(words, ","));
}

bool is_unit_per_time(std::string_view velocity, std::string_view length) {
  if (!velocity.starts_with(length)) return false;
  const std::string_view rest = velocity.substr(length.size());
  if (rest.empty() || !std::isalpha(static_cast<unsigned char>(rest[0]))) return true;
  return rest == "s-1" || rest == "s^-1" || rest == "s**-1";
}

}  // namespace spherepair
