// SPDX-License-Identifier: MIT
#include "common/scene/motion_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "common/scene/known_name.h"

namespace spherepair {
namespace {

constexpr std::array<const char*, 7> motion_names = {"euler",         "symplectic", "paper",   "paper-clamp",
                                                     "impact-linear", "impact",     "anchored"};
constexpr std::array<const char*, 3> precision_names = {"float32", "compensated", "float64"};
static_assert(uint(MotionMethod::euler) == MOTION_EULER && uint(MotionMethod::symplectic) == MOTION_SYMPLECTIC &&
              uint(MotionMethod::paper) == MOTION_PAPER && uint(MotionMethod::paper_clamp) == MOTION_PAPER_CLAMP &&
              uint(MotionMethod::impact_linear) == MOTION_IMPACT_LINEAR &&
              uint(MotionMethod::impact) == MOTION_IMPACT && uint(MotionMethod::anchored) == MOTION_ANCHORED);
static_assert(uint(Precision::float32) == PRECISION_FLOAT32 && uint(Precision::float64) == PRECISION_FLOAT64 &&
              uint(Precision::compensated) == PRECISION_COMPENSATED);

template <size_t count>
uint index_of_name(const std::array<const char*, count>& indices, const std::string& name, const char* what) {
  const auto found = std::ranges::find(indices, name);
  if (found == indices.end()) throw std::invalid_argument(unknown_name(what, name, {indices.begin(), indices.end()}));
  return uint(found - indices.begin());
}

}  // namespace

const std::vector<MotionOptions>& all_motions() {
  static const std::vector<MotionOptions> all = [] {
    std::vector<MotionOptions> motions;
    for (uint method = 0; method < motion_names.size(); ++method)
      for (uint precision = 0; precision < precision_names.size(); ++precision)
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
  return MotionMethod(index_of_name(motion_names, name, "motion method"));
}
Precision precision_from_name(const std::string& name) {
  return Precision(index_of_name(precision_names, name, "precision"));
}

}  // namespace spherepair
