// SPDX-License-Identifier: MIT
// Contacts that push, on a device: the list of near pairs, their impulses, and errors of steps.
#pragma once

#include "common/shared/contact/periodic.h"
#include "common/simulation/motion/device_motion.h"
#include "common/simulation/search/near_pairs.h"

namespace spherepair {

class Contacts {
 public:
  Contacts(DeviceContext& context, DeviceMotion& motion) : context_(context), motion_(motion), near_(context.device) {}

  // Sets the scene's part of the parameters and the buffers. Call it after the motion's upload, whose method decides
  // the buffers, and after the upload of the scene's own search.
  void upload(const Scene& scene, uint64_t steps_before);
  bool on() const { return on_; }
  bool periodic() const { return on_ && periodic_axes(context_.params.contact) != 0; }

  void keep_list(bool on) { keeps_ = on; }  // false: list near pairs in every step
  void forget_list() { made_ = false; }     // the list is overwritten; only when all steps are done

  uint64_t steps() const { return done_ + known_; }  // those before the upload included

  // Launches a step of the motion. It waits for the device only if near pairs must be listed, or soon may have to be.
  // After a sphere leaves its skin, later steps are no-ops; complete() lists near pairs anew, relaunches these steps
  // and returns true. clear_results: the step clears the results of the last search.
  void step(bool clear_results);
  bool complete();

  // Lists near pairs anew, of which a search in a periodic box takes those that collide. All steps must be complete.
  void list_near_pairs(const CollideOptions& options = {.method = Method::automatic});

  void check_guards() { near_.check_guards(); }

  // Throws std::invalid_argument, naming the sphere, if a step since the upload was not possible. No step is taken
  // after such a one. All steps must be complete.
  void require_sound();

 private:
  uint64_t grow_spheres();        // returns the number of spheres and images
  void require_progress() const;  // throws BackendError if the steps done are none or too many
  void launch(bool clear_results);
  Params pair_params() const;
  void launch_pairs(Kernel kernel, const Params& params);

  DeviceContext& context_;
  DeviceMotion& motion_;
  NearPairs near_;  // pairs of the spheres grown by their skins
  // Steps with this list: launched, known to be done, and when to ask next.
  uint launched_ = 0, known_ = 0, next_check_ = 0;
  uint served_ = 1;  // steps that the previous list served
  bool on_ = false, made_ = false, keeps_ = true;
  bool sleeps_ = false;  // spheres may come to rest
  bool tests_all_walls_ = false;
  bool left_ = false;    // the last step known to be done had a sphere leave its skin
  bool failed_ = false;  // that step was not possible
  uint64_t done_ = 0;    // steps before this list
};

}  // namespace spherepair
