// SPDX-License-Identifier: MIT
// Contacts that push, on the CPU: the reference for the kernels contact_grow, contact_pairs and leapfrog.
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
  void keep_list(bool on) { keeps_ = on; }  // false: list near pairs in every step

  void sum_impulses(ImpulseSums sums);

  uint64_t steps() const { return failed_.number; }  // steps since the upload, plus those before it
  void follow(uint64_t steps_before) { failed_.number = steps_before; }
  uint64_t searches() const { return on() ? search_.work().steps : 0; }

  // Makes a step by the impulses of contacts and walls and by gravity. The wide state holds the spheres; positions and
  // velocities get its numbers, rounded to float32.
  void step(std::vector<uint>& wide, std::vector<vec4>& positions, std::vector<vec4>& velocities);

  // Throws std::invalid_argument, naming the sphere, if a step since the upload was not possible. No step is taken
  // after such a one.
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

  CpuSearch search_;  // searches the grown spheres
  int threads_;
  ContactParams params_{};
  bool tests_all_walls_ = false;
  std::vector<int64_t> impulses_;  // as SLOT_IMPULSE
  FailedStep failed_;              // faults as SLOT_FAULT; the other fields only if there are any
  std::vector<vec4> grown_;        // as SLOT_GROWN
  std::vector<Pair> near_;         // as SLOT_NEAR
  std::vector<uint> rest_;         // as SLOT_REST
  std::vector<float> float_sums_;  // replaces impulses_ for sums by atomics
  std::vector<uint> row_;          // near spheres of i from row_begin_[i] on, in ascending order
  std::vector<uint64_t> row_begin_;
  ImpulseSums sums_ = ImpulseSums::integers;
  bool left_skin_ = true, keeps_ = true, may_sleep_ = false;
};

}  // namespace spherepair
