// SPDX-License-Identifier: MIT
// Contacts that push, on the CPU: the reference of the kernels contact_grow, contact_pairs and leapfrog.
#pragma once

#include "common/cpu/cpu_search.h"
#include "common/scene/contact/contact_faults.h"
#include "common/shared/contact/contact_rest.h"

namespace spherepair {

class CpuContacts {
 public:
  CpuContacts(const BackendInfo& info, int threads) : search_(info, threads), threads_(threads) {}

  void upload(const Scene& scene);
  bool on() const { return params_.law != CONTACT_NONE; }
  void keep_list(bool on) { keeps_ = on; }  // of near pairs; else they are listed in every step

  void sum_impulses(ImpulseSums sums);

  uint64_t steps() const { return failed_.number; }  // since the upload, and those before it
  void follow(uint64_t steps_before) { failed_.number = steps_before; }
  uint64_t searches() const { return on() ? search_.work().steps : 0; }

  // A step of spheres in the wide state, by the impulses of their contacts, walls and gravity. Positions and velocities
  // become the nearest float32 numbers.
  void step(std::vector<uint>& wide, std::vector<vec4>& positions, std::vector<vec4>& velocities);

  // Throws std::invalid_argument naming the sphere where a step since the upload was not possible; none was taken
  // since.
  void require_sound() const;

 private:
  void list_near_pairs(const std::vector<vec4>& positions);
  void list_rows(uint64_t n);
  void awaken();
  bool sleeps() const { return may_sleep_ && sums_ == ImpulseSums::integers; }
  bool is_at_rest(uint64_t i) const { return sleeps() && rest_[i] == REST_SAME; }
  void push(const std::vector<uint>& wide, const std::vector<vec4>& positions);
  void gather(const std::vector<uint>& wide, const std::vector<vec4>& positions);
  int64_t take_impulse(uint64_t k);
  void record(uint fault, uint64_t sphere);

  CpuSearch search_;  // of the grown spheres
  int threads_;
  ContactParams params_{};
  bool tests_all_walls_ = false;
  std::vector<int64_t> impulses_;  // as SLOT_IMPULSE
  FailedStep failed_;              // its faults as SLOT_FAULT; the rest where there are any
  std::vector<vec4> grown_;        // as SLOT_GROWN
  std::vector<Pair> near_;         // as SLOT_NEAR
  std::vector<uint> rest_;         // as SLOT_REST
  std::vector<float> float_sums_;  // in place of impulses_, for sums by atomics
  std::vector<uint> row_;          // near spheres of all, those of i from row_begin_[i] on, in ascending order
  std::vector<uint64_t> row_begin_;
  ImpulseSums sums_ = ImpulseSums::integers;
  bool left_skin_ = true, keeps_ = true, may_sleep_ = false;
};

}  // namespace spherepair
