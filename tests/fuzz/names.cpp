// SPDX-License-Identifier: MIT
// Names and numbers that options hold: each parser knows the text or refuses it.
#include <cstdlib>
#include <regex>

#include "bench/io/arguments.h"
#include "bench/io/scene_text.h"
#include "bench/spheres/columns.h"
#include "bench/spheres/xyz_columns.h"
#include "tests/fuzz/fuzz.h"

using namespace spherepair;

namespace {

void try_decimal(const std::string& text) {
  const auto decimal = parse_decimal(text);
  if (!decimal) return;
  const std::string plain = std::regex_replace(text, std::regex("([0-9.])[dD]"), "$1e");  // as Fortran writes exponents
  char* end = nullptr;
  const float nearest = std::strtof(plain.c_str(), &end);
  const bool same = float_bits(nearest) == float_bits(decimal->rounded) ||
                    (nearest != nearest && decimal->rounded != decimal->rounded);
  require(*end == 0 && same, "a decimal is rounded as strtof rounds it");
}

}  // namespace

FUZZ(names) {
  const std::string text(text_of(data, size));
  const auto scene = unless_refused([&] { return parse_scene(text, 1); });
  if (scene && scene->n <= 1000) unless_refused([&] { return make_scene(*scene); });
  unless_refused([&] { return parse_methods({text}); });
  unless_refused([&] { return motion_from_name(text); });
  unless_refused([&] { return precision_from_name(text); });
  unless_refused([&] { return draw_method_from_name(text); });
  try_decimal(text);
}
