// SPDX-License-Identifier: MIT
#include "common/simulation/contacts.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/scene/contact_scene.h"
#include "common/shared/skin.h"

namespace spherepair {
namespace {

constexpr uint64_t most_groups = 4096;  // which take turns

}  // namespace

void Contacts::upload(const Scene& scene) {
  on_ = scene.contact.law != ContactLaw::none;
  made_ = left_ = false;
  launched_ = known_ = next_check_ = 0;
  served_ = 1;
  context_.params.contact = contact_params(scene);
  const uint64_t n = on_ ? context_.n : 0;
  for (uint axis = 0; axis < 3; ++axis) {
    context_.buffers.resize(SLOT_IMPULSE + axis, n * sizeof(int64_t));
    context_.buffers.write(SLOT_IMPULSE + axis, std::vector<int64_t>(n));
  }
  context_.buffers.resize(SLOT_GROWN, n * sizeof(vec4));
  if (!on_) return;
  context_.buffers.resize(SLOT_FAULT, FAULT_WORDS * sizeof(uint));
  context_.buffers.write(SLOT_FAULT, std::vector<uint>(FAULT_WORDS, ~0u));
  near_.plan(grown_scene(scene));
}

bool Contacts::step(bool clear_results) {
  motion_.begin_step();
  near_.moved();
  bool listed = false;
  if (launched_ >= next_check_ || left_ || !keeps_) {
    listed = complete();
    if (!made_ || left_ || !keeps_) {
      served_ = std::max(launched_, 1u);
      list_near_pairs();
      listed = true;
    }
    next_check_ = launched_ == 0 ? served_ - served_ / 4 : launched_ + 1 + served_ / 16;
  }
  launch(clear_results);
  return listed;
}

bool Contacts::complete() {
  bool listed = false;
  while (known_ != launched_) {
    const std::vector<uint> words = context_.buffers.read<uint>(SLOT_FAULT, FAULT_WORDS);
    left_ = words[LEFT_SKIN] != ~0u;
    known_ = words[STEPS_DONE];
    if (known_ == launched_) break;
    const uint again = launched_ - known_;
    served_ = known_;
    list_near_pairs();
    listed = true;
    for (uint step = 0; step < again; ++step) launch(false);
  }
  return listed;
}

void Contacts::launch(bool clear_results) {
  ++launched_;
  Params params = context_.params;  // the same for all steps, so that they are sent once
  params.motion.clear_results = clear_results;
  params.search.near_pairs = context_.near_pairs;
  const auto groups = folded(std::clamp<uint64_t>(ceil_div(context_.near_pairs, SERVICE_BLOCK), 1, most_groups));
  context_.device.launch({Kernel::contact_pairs, SERVICE_BLOCK, {}, groups}, params);
  context_.device.launch({Kernel::leapfrog, SERVICE_BLOCK, {}, groups_per_sphere(context_)}, params);
}

void Contacts::list_near_pairs() {
  made_ = left_ = false;  // until it is, should that fail
  launched_ = known_ = 0;
  context_.launch({Kernel::contact_grow, SERVICE_BLOCK, {}, groups_per_sphere(context_)});
  near_.list();
  made_ = true;
}

void Contacts::require_sound() {
  if (!on_) return;
  const std::string faults = describe_faults(context_.buffers.read<uint>(SLOT_FAULT, FAULTS));
  if (!faults.empty()) throw std::invalid_argument(fmt::format("{}: {}", context_.name(), faults));
}

}  // namespace spherepair
