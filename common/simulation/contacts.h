// SPDX-License-Identifier: MIT
// Contacts that push, on a device: the list of near pairs, their impulses, and what a step could not do.
#pragma once

#include "common/simulation/motion/device_motion.h"
#include "common/simulation/search/near_pairs.h"

namespace spherepair {

class Contacts {
 public:
  Contacts(DeviceContext& context, DeviceMotion& motion) : context_(context), motion_(motion), near_(context.device) {}

  // The scene's part of the parameters; after the motion's upload, whose method decides what the buffers are for, and
  // after that of the scene's own search.
  void upload(const Scene& scene, uint64_t steps_before);
  bool on() const { return on_; }

  void keep_list(bool on) { keeps_ = on; }  // else near pairs are listed in every step
  void forget_list() { made_ = false; }     // others are being listed; where all steps are done

  // From the next step on, for measuring; all steps before must be complete.
  void sum_impulses(ImpulseSums sums);
  ImpulseSums sums() const { return sums_; }

  uint64_t steps() const { return done_ + known_; }  // those before the upload included

  // Launches a step of the motion. It waits for the device only where near pairs have to be listed, or may have to be
  // soon: the steps behind one in which a sphere left its skin do nothing, and are launched again by `complete`, which
  // then returns true. clear_results: the step clears the results of the last search.
  void step(bool clear_results);
  bool complete();

  void check_guards() { near_.check_guards(); }

  // Throws std::invalid_argument naming the sphere where a step since the upload was not possible; none was taken
  // since. All steps must be complete.
  void require_sound();

 private:
  void list_near_pairs();
  void list_rows();
  void require_progress() const;  // throws BackendError where the steps done are none, or more than were launched
  void launch(bool clear_results);
  Params pair_params() const;
  void launch_impulses(const Params& params);
  void launch_pairs(Kernel kernel, const Params& params);
  Variant variant() const { return {.float_sums = sums_ == ImpulseSums::atomics}; }

  DeviceContext& context_;
  DeviceMotion& motion_;
  NearPairs near_;  // of the spheres grown by their skins
  // Steps since they were listed: launched, of these known to be done, and when to ask next.
  uint launched_ = 0, known_ = 0, next_check_ = 0;
  uint served_ = 1;  // steps by the list before
  ImpulseSums sums_ = ImpulseSums::integers;
  bool on_ = false, made_ = false, keeps_ = true;
  bool sleeps_ = false;  // spheres may come to rest
  bool tests_all_walls_ = false;
  bool left_ = false;    // a sphere has left its skin in the last step known to be done
  bool failed_ = false;  // that step could not be taken
  uint64_t done_ = 0;    // steps before the list
};

}  // namespace spherepair
