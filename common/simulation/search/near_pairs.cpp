// SPDX-License-Identifier: MIT
#include "common/simulation/search/near_pairs.h"

#include <fmt/format.h>

#include <utility>

#include "common/backend/swept_paths.h"

namespace spherepair {

void NearPairs::plan(const Scene& grown) {
  radius_ = common_radius(grown);
  equal_radii_ = grown.equal_radii;
  sorter_.upload(grown);
  search_.upload(grown);
  context_.buffers.resize(SLOT_NEAR, context_.buffers.bytes(SLOT_PAIR));
}

// The grown spheres stand in for the scene's until their pairs are listed.
void NearPairs::list(const CollideOptions& options) {
  sorter_.replaced();
  search_.moved(false);
  float radius = radius_;
  bool equal = equal_radii_;
  const auto exchange = [&] {
    context_.buffers.swap(SLOT_POSITION, SLOT_GROWN);
    std::swap(context_.params.radius, radius);
    std::swap(context_.equal_radii, equal);
  };
  exchange();
  try {
    context_.near_pairs = uint(search_.list_pairs(options));
  } catch (...) {
    exchange();
    throw;
  }
  exchange();
  context_.buffers.swap(SLOT_PAIR, SLOT_NEAR);
}

void NearPairs::list_of(const Scene& grown, const CollideOptions& options) {
  context_.buffers.resize(SLOT_GROWN, context_.n * sizeof(vec4));
  context_.buffers.write(SLOT_GROWN, grown.positions);
  plan(grown);
  list(near_options(options));
}

void NearPairs::list_paths(const CollideOptions& options) {
  motion_.require_movable();
  motion_.evaluate_state();
  const Backend::State state = motion_.state();
  const MotionOptions motion = motion_.options();
  const MotionState saved = motion.method == MotionMethod::anchored ? motion_.save() : MotionState{};
  const std::vector<vec4> velocities = path_velocities(state, saved, motion, context_.params, [&](const Scene& grown) {
    list_of(grown, options);
    return context_.buffers.read<Pair>(SLOT_NEAR, context_.near_pairs);
  });
  const Scene paths = spheres_around_paths(state.positions, velocities, context_.params.motion);
  try {
    list_of(paths, options);
  } catch (const BackendError& error) {
    throw BackendError(fmt::format(
        "{}; these are pairs of paths that are near each other within the next step: a smaller --dt has fewer",
        error.what()));
  }
  context_.buffers.write(SLOT_GROWN, velocities);
}

}  // namespace spherepair
