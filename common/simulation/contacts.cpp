// SPDX-License-Identifier: MIT
#include "common/simulation/contacts.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/scene/contact/contact_faults.h"
#include "common/scene/contact_scene.h"
#include "common/shared/contact/contact_rest.h"

namespace spherepair {
namespace {

constexpr uint64_t most_groups = 4096;  // upper limit; groups loop over the rest

}  // namespace

void Contacts::upload(const Scene& scene, uint64_t steps_before) {
  on_ = scene.contact.law != ContactLaw::none;
  made_ = left_ = failed_ = false;
  launched_ = known_ = next_check_ = 0;
  done_ = steps_before;
  served_ = 1;
  sleeps_ = may_sleep(scene), tests_all_walls_ = scene.contact.tests_all_walls;
  context_.params.contact = contact_params(scene);
  context_.set_near({});
  near_.release();
  const uint64_t n = on_ ? context_.n : 0;
  for (uint axis = 0; axis < 3; ++axis) {
    context_.buffers.resize(SLOT_IMPULSE + axis, n * sizeof(int64_t));
    if (on_) context_.buffers.clear(SLOT_IMPULSE + axis, n * sizeof(int64_t));
  }
  context_.buffers.resize(SLOT_GROWN, n * sizeof(vec4));
  context_.buffers.resize(SLOT_IMAGE_OF, periodic() ? sizeof(uint) : 0);
  context_.buffers.resize(SLOT_REST, sleeps_ ? n * sizeof(uint) : 0);
  if (!on_) return near_.forget();
  context_.buffers.resize(SLOT_FAULT, FAULT_WORDS * sizeof(uint));
  context_.buffers.write(SLOT_FAULT, std::vector<uint>(FAULT_WORDS, ~0u));
  near_.plan(grown_scene(scene));
}

void Contacts::step(bool clear_results) {
  motion_.begin_step();
  near_.moved();
  if (!made_ || launched_ >= next_check_ || left_ || !keeps_) {
    complete();
    if (failed_) return;
    if (!made_ || left_ || !keeps_) {
      if (left_) served_ = std::max(launched_, 1u);
      list_near_pairs();
    }
    next_check_ = std::max(served_ - served_ / 4, launched_ + 1 + std::max(served_, launched_) / 8);
  }
  launch(clear_results);
}

bool Contacts::complete() {
  bool repeated = false;
  while (known_ != launched_ && !failed_) {
    const std::vector<uint> words = context_.buffers.read<uint>(SLOT_FAULT, FAULT_WORDS);
    left_ = words[LEFT_SKIN] != ~0u;
    failed_ = has_faults(words);
    known_ = words[STEPS_DONE];
    if (known_ == launched_ || failed_) break;
    require_progress();
    const uint again = launched_ - known_;
    served_ = known_;
    list_near_pairs();
    repeated = true;
    for (uint step = 0; step < again; ++step) launch(false);
  }
  return repeated;
}

// Throws unless the steps done are at least one and fewer than were launched: every list serves at least one step.
void Contacts::require_progress() const {
  if (known_ > 0 && known_ < launched_) return;
  throw BackendError(
      fmt::format("{}: of {} steps with contacts that were launched, the device counts {} as done: kernels or launches "
                  "of its driver fail; update the driver, or choose another backend",
                  context_.name(), launched_, known_));
}

void Contacts::launch(bool clear_results) {
  ++launched_;
  Params params = pair_params();  // equal for both launches and all steps, so sent once
  params.motion.clear_results = clear_results;
  const auto by_sphere = groups_per_sphere(context_);
  context_.device.begin_step({});
  if (sleep_mode(params.contact) != SLEEP_NEVER) {
    Params awakening = params;
    awakening.contact.sleeping = SLEEP_AWAKENS;
    launch_pairs(Kernel::contact_pairs, awakening);
  }
  launch_pairs(Kernel::contact_pairs, params);
  context_.launch({Kernel::leapfrog, SERVICE_BLOCK, {}, by_sphere}, params);
  context_.device.end_step();
}

Params Contacts::pair_params() const {
  Params params = context_.params;
  params.search.near_pairs = context_.near_pairs;
  return params;
}

void Contacts::launch_pairs(Kernel kernel, const Params& params) {
  const auto groups = folded(std::clamp<uint64_t>(ceil_div(context_.near_pairs, SERVICE_BLOCK), 1, most_groups));
  context_.launch({kernel, SERVICE_BLOCK, {}, groups}, params);
}

// Grows the spheres. In a periodic box it does so again until there is room for all their images.
uint64_t Contacts::grow_spheres() {
  Buffers& buffers = context_.buffers;
  for (;;) {
    if (periodic()) buffers.clear(SLOT_IMAGE_OF, sizeof(uint));
    context_.launch({Kernel::contact_grow, SERVICE_BLOCK, {}, groups_per_sphere(context_)});
    if (!periodic()) return context_.n;
    const uint images = buffers.read<uint>(SLOT_IMAGE_OF, 1)[0];
    uint& capacity = context_.params.image_capacity;
    if (images <= capacity) return context_.n + images;
    near_.release();  // so that the spheres can grow in place
    const uint room = images + images / 4;
    buffers.resize(SLOT_GROWN, (context_.n + room) * sizeof(vec4));
    buffers.resize(SLOT_IMAGE_OF, (1 + uint64_t(room)) * sizeof(uint));
    capacity = room;
  }
}

void Contacts::list_near_pairs(const CollideOptions& options) {
  made_ = left_ = false;  // made_ stays false if the list fails
  done_ += known_;
  launched_ = known_ = 0;
  context_.params.contact.sleeping =
      (sleeps_ ? SLEEP_AT_REST : SLEEP_NEVER) | (tests_all_walls_ ? TESTS_ALL_WALLS : 0u);
  const uint64_t all = grow_spheres();
  context_.set_near({});  // so that the list can grow in place
  context_.set_near(near_.list(context_.buffers.memory(SLOT_GROWN), all, options));
  if (periodic()) launch_pairs(Kernel::contact_images, pair_params());
  made_ = true;
}

void Contacts::require_sound() {
  if (!failed_) return;
  const Motion::State state = motion_.state();
  throw_fault(context_.name(),
              {context_.buffers.read<uint>(SLOT_FAULT, FAULTS), steps(), bodies_of(state.wide, state.positions)},
              context_.params.contact);
}

}  // namespace spherepair
