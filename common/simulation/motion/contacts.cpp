// SPDX-License-Identifier: MIT
#include "common/simulation/motion/contacts.h"

#include <fmt/format.h>

#include "common/scene/contact_scene.h"

namespace spherepair {
namespace {

constexpr uint64_t most_groups = 4096;  // which take turns

}  // namespace

void Contacts::upload(const Scene& scene) {
  on_ = scene.contact.law != ContactLaw::none;
  context_.params.contact = contact_params(scene);
  if (!on_) return;
  context_.buffers.resize(SLOT_IMPULSE, 3 * scene.size() * sizeof(int64_t));
  context_.buffers.write(SLOT_IMPULSE, std::vector<int64_t>(3 * scene.size()));
  context_.buffers.resize(SLOT_FAULT, FAULTS * sizeof(uint));
  context_.buffers.write(SLOT_FAULT, std::vector<uint>(FAULTS, ~0u));
}

void Contacts::push() {
  if (context_.n < 2) return;
  context_.launch({.kernel = Kernel::contact_pairs,
                   .block = SERVICE_BLOCK,
                   .variant = {},
                   .groups = folded(std::min(ceil_div(context_.n, SERVICE_BLOCK), most_groups))});
}

void Contacts::require_sound() {
  if (!on_) return;
  const std::string faults = describe_faults(context_.buffers.read<uint>(SLOT_FAULT, FAULTS));
  if (!faults.empty()) throw std::invalid_argument(fmt::format("{}: {}", context_.name(), faults));
}

}  // namespace spherepair
