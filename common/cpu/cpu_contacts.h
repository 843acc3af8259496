// SPDX-License-Identifier: MIT
// Contacts that push, on the CPU: the reference of the kernels contact_pairs and leapfrog.
#pragma once

#include <span>

#include "common/backend/backend.h"

namespace spherepair {

class CpuContacts {
 public:
  void upload(const Scene& scene);
  bool on() const { return params_.law != CONTACT_NONE; }

  // A step of spheres in the wide state, by the impulses of these pairs, walls and gravity; in any order, since they
  // are integers. Positions and velocities become the nearest float32 numbers.
  void step(std::span<const Pair> pairs, std::vector<uint>& wide, std::vector<vec4>& positions,
            std::vector<vec4>& velocities, int threads);

  // Throws std::invalid_argument naming the sphere where a step since the upload was not possible.
  void require_sound() const;

 private:
  void push(std::span<const Pair> pairs, const std::vector<uint>& wide, const std::vector<vec4>& positions,
            int threads);
  void record(uint fault, uint64_t sphere);

  ContactParams params_{};
  std::vector<int64_t> impulses_;  // as SLOT_IMPULSE
  std::vector<uint> faults_;       // as SLOT_FAULT
};

}  // namespace spherepair
