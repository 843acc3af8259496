// SPDX-License-Identifier: MIT
// A backend that answers wrongly in one known way, to test the harness.
#pragma once

#include <string>
#include <vector>

#include "bench/measure/session.h"

namespace spherepair {

enum class Fault {
  none,
  // The whole set is wrong, but totals, counts and list agree with each other.
  dropped_pair,   // the first pair is missing
  added_pair,     // a pair of separate spheres is in the set
  swapped_pairs,  // two pairs exchange a partner: no count changes
  // One part of the answer is wrong and contradicts the others.
  pair_total,
  colliding_total,
  fingerprint,         // its first half ...
  second_fingerprint,  // ... and its second
  sphere_count,        // of sphere 7
  count_missing,       // counts of one sphere fewer
  listed_pair,         // only in the list one pair is another
  // The state is wrong; in a wide state also in digits beyond float32.
  position_bit,  // z of sphere 3
  velocity_bit,  // y of sphere 3
  radius_bit,
  wide_bit,
  velocity_missing,   // velocities of one sphere fewer
  infinite_position,  // x of sphere 3
  image_pixel,
  // Steps with contacts, and a resumed run (faulty_contacts.h).
  lost_near_pair,  // after the first list, the first touching pair gets no impulse, as if a list lacked it
  moves_at_rest,   // a sphere at rest goes two units of length a step along x
  stays_at_rest,   // a sphere that is hit stays at rest
  drag_once_more,  // momenta are slowed by half a step's drag once more
  old_momenta,     // a resumed run makes its momenta of the velocities, as a start does
  // Forbidden actions of kernels, and a backend without methods.
  guard_overwritten,
  no_methods
};

struct NamedFault {
  const char* name;
  Fault fault;
  const char* found_as;  // part of the message that must name it
};
const std::vector<NamedFault>& set_faults();      // faults that a comparison of sets must find
const std::vector<NamedFault>& state_faults();    // faults that a comparison of states must find
const std::vector<NamedFault>& contact_faults();  // faults that a comparison of states with contacts must find
Fault fault_from_name(const std::string& name);

// The CPU backend under this name. It answers correctly until `from_step` moves after the upload, then wrongly.
std::unique_ptr<Backend> make_faulty(const std::string& name, Fault fault, uint64_t from_step = 0);

// Opens the real CPU backend, and a faulty one under the name `opengl`. Refuses other names.
Opener faulty_opener(Fault fault, uint64_t from_step = 0);

}  // namespace spherepair
