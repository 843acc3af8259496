// SPDX-License-Identifier: MIT
// A backend that answers wrongly in one known way: what the harness is tested with.
#pragma once

#include <string>
#include <vector>

#include "bench/measure/session.h"

namespace spherepair {

enum class Fault {
  none,
  // The whole set is another one, told without a contradiction by totals, counts and list.
  dropped_pair,   // the first pair is missing
  added_pair,     // a pair that is apart is there
  swapped_pairs,  // two pairs exchange a partner: every count stays as it was
  // One part of the answer is wrong and contradicts the others.
  pair_total,
  colliding_total,
  fingerprint,         // its first half ...
  second_fingerprint,  // ... and its second
  sphere_count,        // of sphere 7
  count_missing,       // counts of one sphere fewer
  listed_pair,         // another pair in the list alone
  // The state; in a wide state also where the float32 numbers do not show it.
  position_bit,  // z of sphere 3
  velocity_bit,  // y of sphere 3
  radius_bit,
  wide_bit,
  velocity_missing,   // velocities of one sphere fewer
  infinite_position,  // x of sphere 3
  image_pixel,
  // Steps with contacts, and a resumed run (faulty_contacts.h).
  lost_near_pair,  // the first pair that touches has no impulse, as if a list lacked it: behind the first list
  moves_at_rest,   // a sphere at rest goes two units of length a step along x
  stays_at_rest,   // a sphere that is hit stays at rest
  drag_once_more,  // momenta are slowed by half a step's drag once more
  old_momenta,     // a resumed run makes its momenta of the velocities, as a start does
  // What a kernel must not do, and a backend without methods.
  guard_overwritten,
  no_methods
};

struct NamedFault {
  const char* name;
  Fault fault;
  const char* found_as;  // part of the message that must name it
};
const std::vector<NamedFault>& set_faults();      // that a comparison of sets must find
const std::vector<NamedFault>& state_faults();    // that a comparison of states must find
const std::vector<NamedFault>& contact_faults();  // and of states with contacts
Fault fault_from_name(const std::string& name);

// The CPU backend under this name, which answers wrongly after so many moves since the upload, and until then rightly.
std::unique_ptr<Backend> make_faulty(const std::string& name, Fault fault, uint64_t from_step = 0);

// Opens the real CPU backend, and a faulty one under the name `opengl`. Refuses other names.
Opener faulty_opener(Fault fault, uint64_t from_step = 0);

}  // namespace spherepair
