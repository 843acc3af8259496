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

  uint64_t steps() const { return failed_.number; }  // steps since the upload, plus those before it
  void follow(uint64_t steps_before) { failed_.number = steps_before; }
  uint64_t searches() const { return on() ? search_.work().steps : 0; }

  // Makes a step by the impulses of contacts and walls and by gravity. The wide state holds the spheres; positions and
  // velocities get its numbers, rounded to float32.
  void step(std::vector<uint>& wide, std::vector<vec4>& positions, std::vector<vec4>& velocities);

  bool periodic() const { return periodic_axes(params_) != 0; }
  // Lists the near pairs anew, of which some collide now, also across faces of a periodic box.
  const std::vector<Pair>& near_pairs(const std::vector<uint>& wide, const std::vector<vec4>& positions);

  // Throws std::invalid_argument, naming the sphere, if a step since the upload was not possible. No step is taken
  // after such a one.
  void require_sound() const;

 private:
  void list_near_pairs(const std::vector<uint>& wide, const std::vector<vec4>& positions);
  std::vector<uint> add_images(const std::vector<uint>& wide, const std::vector<vec4>& positions);
  void awaken();
  bool is_at_rest(uint64_t i) const { return may_sleep_ && rest_[i] == REST_SAME; }
  void push(const std::vector<uint>& wide, const std::vector<vec4>& positions);
  void record(uint fault, uint64_t sphere);

  CpuSearch search_;  // searches the grown spheres
  int threads_;
  ContactParams params_{};
  bool tests_all_walls_ = false;
  std::vector<int64_t> impulses_;  // as SLOT_IMPULSE
  FailedStep failed_;              // faults as SLOT_FAULT; the other fields only if there are any
  std::vector<vec4> grown_;        // as SLOT_GROWN, with images
  std::vector<Pair> near_;         // as SLOT_NEAR
  std::vector<uint> rest_;         // as SLOT_REST
  bool left_skin_ = true, keeps_ = true, may_sleep_ = false;
};

}  // namespace spherepair
