// SPDX-License-Identifier: MIT
#include "common/scene/motion_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>

#include "common/scene/contact/contact_options.h"
#include "common/scene/known_name.h"

namespace spherepair {
namespace {

constexpr std::array<const char*, 8> motion_names = {"euler",         "symplectic", "paper",    "paper-clamp",
                                                     "impact-linear", "impact",     "anchored", "leapfrog"};
constexpr std::array<const char*, 4> precision_names = {"float32", "compensated", "float64", "fixed"};
constexpr std::array<const char*, 4> law_names = {"none", "spring", "quartic", "hertz"};
constexpr size_t free_methods = 7, free_precisions = 3;  // the first entries: without contacts
static_assert(uint(MotionMethod::euler) == MOTION_EULER && uint(MotionMethod::symplectic) == MOTION_SYMPLECTIC &&
              uint(MotionMethod::paper) == MOTION_PAPER && uint(MotionMethod::paper_clamp) == MOTION_PAPER_CLAMP &&
              uint(MotionMethod::impact_linear) == MOTION_IMPACT_LINEAR &&
              uint(MotionMethod::impact) == MOTION_IMPACT && uint(MotionMethod::anchored) == MOTION_ANCHORED &&
              uint(MotionMethod::leapfrog) == MOTION_LEAPFROG);
static_assert(uint(Precision::float32) == PRECISION_FLOAT32 && uint(Precision::float64) == PRECISION_FLOAT64 &&
              uint(Precision::compensated) == PRECISION_COMPENSATED && uint(Precision::fixed) == PRECISION_FIXED);

static_assert(uint(ContactLaw::none) == CONTACT_NONE && uint(ContactLaw::spring) == CONTACT_SPRING &&
              uint(ContactLaw::quartic) == CONTACT_QUARTIC && uint(ContactLaw::hertz) == CONTACT_HERTZ);

uint index_of_name(std::span<const char* const> indices, const std::string& name, const char* what) {
  const auto found = std::ranges::find(indices, name);
  if (found == indices.end()) throw std::invalid_argument(unknown_name(what, name, {indices.begin(), indices.end()}));
  return uint(found - indices.begin());
}

}  // namespace

const std::vector<MotionOptions>& all_motions() {
  static const std::vector<MotionOptions> all = [] {
    std::vector<MotionOptions> motions;
    for (uint method = 0; method < free_methods; ++method)
      for (uint precision = 0; precision < free_precisions; ++precision)
        motions.push_back({MotionMethod(method), Precision(precision)});
    return motions;
  }();
  return all;
}

const char* motion_name(MotionMethod method) { return motion_names[size_t(method)]; }
const char* precision_name(Precision precision) { return precision_names[size_t(precision)]; }
std::string motion_label(MotionOptions motion) {
  return fmt::format("{} {}", motion_name(motion.method), precision_name(motion.precision));
}

MotionMethod motion_from_name(const std::string& name) {
  return MotionMethod(index_of_name(std::span(motion_names).first(free_methods), name, "motion method"));
}
std::string axes_text(uint axes) {
  std::string text;
  for (uint axis = 0; axis < 3; ++axis)
    if (axes >> axis & 1) text += "xyz"[axis];
  return text;
}

const char* contact_name(ContactLaw law) { return law_names[size_t(law)]; }
ContactLaw contact_from_name(const std::string& name) {
  return ContactLaw(index_of_name(law_names, name, "contact law"));
}
Precision precision_from_name(const std::string& name) {
  return Precision(index_of_name(std::span(precision_names).first(free_precisions), name, "precision"));
}

}  // namespace spherepair
