// SPDX-License-Identifier: MIT
// Finds the colliding pairs of a scene's spheres at their current positions.
#pragma once

#include "common/backend/collide_options.h"
#include "common/backend/scene_holder.h"

namespace spherepair {

class Search : public virtual SceneHolder {
 public:
  // Returns the methods of this backend, without `automatic`.
  virtual std::vector<Method> methods() const = 0;
  virtual MethodChoice choice(const CollideOptions& options) const = 0;

  // Finds the pairs completely: every list has room and every pair is decided. Reading the results afterwards launches
  // nothing.
  virtual void collide(const CollideOptions& options) = 0;
  // For timing: enqueues the same search and returns. It has no readable results: it omits decisions that the last
  // complete search of this kind did not need, the growth of lists that are too short, and the number of colliding
  // spheres.
  virtual void enqueue_collide(const CollideOptions& options) = 0;

  // Results of the last collide(). They throw BackendError if the spheres have moved since, or if the search was only
  // enqueued.
  virtual Collisions collisions() = 0;
  virtual std::vector<uint> counts() = 0;  // contacts of each sphere
  virtual std::vector<Pair> pairs() = 0;   // in canonical order; needs want_pairs
};

// A sphere collides (the paper's flag, which sets its colour) if it has contacts.
inline bool colliding(uint count) { return count != 0; }

}  // namespace spherepair
