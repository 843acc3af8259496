// SPDX-License-Identifier: MIT
// Scenes made for contacts that push.
#pragma once

#include "common/scene/scene.h"

namespace spherepair {

struct SceneMaker {
  SceneKind kind;
  void (*make)(Scene&, const SceneOptions&);
};
const std::vector<SceneMaker>& contact_makers();
bool made_for_contacts(const std::string& name);

}  // namespace spherepair
