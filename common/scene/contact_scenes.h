// SPDX-License-Identifier: MIT
// Scenes for contacts that push.
#pragma once

#include "common/scene/scene.h"

namespace spherepair {

struct SceneMaker {
  SceneKind kind;
  void (*make)(Scene&, const SceneOptions&);
};
const std::vector<SceneMaker>& contact_makers();
bool made_for_contacts(const std::string& name);

// Makes square layers, each in the hollows of the one below and touching it, in a box as wide as the even layers. With
// --contact they come to rest in some thousand steps, the scene bed in a million.
Scene packed_bed(uint64_t n, uint64_t layers);

}  // namespace spherepair
