// SPDX-License-Identifier: MIT
#include "common/simulation/swept_search.h"

#include <fmt/format.h>

#include "common/backend/swept_paths.h"

namespace spherepair {

void SweptSearch::list_of(const Scene& grown, const CollideOptions& options) {
  context_.set_near({});  // so that list and spheres can grow in place
  near_.release();
  context_.buffers.resize(SLOT_GROWN, context_.n * sizeof(vec4));
  context_.buffers.write(SLOT_GROWN, grown.positions);
  near_.plan(grown);
  context_.set_near(near_.list(context_.buffers.memory(SLOT_GROWN), context_.n, near_options(options)));
}

void SweptSearch::list_paths(const CollideOptions& options) {
  motion_.require_movable();
  motion_.evaluate_state();
  const Motion::State state = motion_.state();
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
