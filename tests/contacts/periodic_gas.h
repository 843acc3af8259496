// SPDX-License-Identifier: MIT
// Tests of periodic contacts start from this gas.
#pragma once

#include "common/scene/contact_scene.h"
#include "tests/support/soft_contacts.h"

namespace spherepair {

constexpr uint AXES[] = {7, 1, 6, 5};

// The gas of a closed box, whose box repeats along these axes.
inline Scene periodic_gas(uint axes, const GasOptions& options = {}) {
  Scene scene = gas(options);
  choose_contacts(scene, {.law = options.law, .stiffness = scene.contact.stiffness, .dt = scene.dt, .periodic = axes});
  EXPECT_EQ(why_no_contacts(scene), "");
  return scene;
}

}  // namespace spherepair
