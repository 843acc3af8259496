// SPDX-License-Identifier: MIT
#include "common/simulation/contacts.h"

#include <fmt/format.h>

#include <utility>

#include "common/scene/contact_scene.h"

namespace spherepair {
namespace {

constexpr uint64_t most_groups = 4096;  // which take turns

}  // namespace

void Contacts::upload(const Scene& scene) {
  on_ = scene.contact.law != ContactLaw::none;
  made_ = false;
  context_.params.contact = contact_params(scene);
  if (!on_) return;
  const uint64_t n = scene.size();
  context_.buffers.resize(SLOT_IMPULSE, 3 * n * sizeof(int64_t));
  context_.buffers.write(SLOT_IMPULSE, std::vector<int64_t>(3 * n));
  context_.buffers.resize(SLOT_FAULT, FAULTS * sizeof(uint));
  context_.buffers.write(SLOT_FAULT, std::vector<uint>(FAULTS, ~0u));
  context_.buffers.resize(SLOT_GROWN, n * sizeof(vec4));
  context_.buffers.resize(SLOT_NEAR, context_.buffers.bytes(SLOT_PAIR));
  const Scene grown = grown_scene(scene);
  grown_radius_ = common_radius(grown);
  sorter_.upload(grown);
  search_.upload(grown);
}

bool Contacts::serves() { return made_ && keeps_ && context_.buffers.read<uint>(SLOT_FAULT, FAULTS)[LEFT_SKIN] == ~0u; }

bool Contacts::update_list() {
  sorter_.moved();
  if (context_.n < 2 || serves()) return false;
  list_near_pairs();
  return true;
}

// The grown spheres stand in for the spheres until their pairs are listed.
void Contacts::list_near_pairs() {
  made_ = false;  // until it is, should that fail
  context_.launch({Kernel::contact_grow, SERVICE_BLOCK, {}, groups_per_sphere(context_)});
  sorter_.replaced();
  search_.moved(false);
  const float radius = std::exchange(context_.params.radius, grown_radius_);
  context_.buffers.swap(SLOT_POSITION, SLOT_GROWN);
  const auto restore = [&] {
    context_.buffers.swap(SLOT_POSITION, SLOT_GROWN);
    context_.params.radius = radius;
  };
  try {
    listed_ = search_.list_pairs();
  } catch (...) {
    restore();
    throw;
  }
  restore();
  context_.buffers.swap(SLOT_PAIR, SLOT_NEAR);
  made_ = true;
}

void Contacts::push() {
  Params params = context_.params;
  params.search.pair_capacity = uint(listed_);
  if (listed_ == 0) return;
  context_.device.launch({.kernel = Kernel::contact_pairs,
                          .block = SERVICE_BLOCK,
                          .variant = {},
                          .groups = folded(std::min(ceil_div(listed_, SERVICE_BLOCK), most_groups))},
                         params);
}

void Contacts::require_sound() {
  if (!on_) return;
  const std::string faults = describe_faults(context_.buffers.read<uint>(SLOT_FAULT, FAULTS));
  if (!faults.empty()) throw std::invalid_argument(fmt::format("{}: {}", context_.name(), faults));
}

}  // namespace spherepair
