// SPDX-License-Identifier: MIT
// Scenes on the command line, in messages and in records.
#pragma once

#include "bench/io/report.h"
#include "common/scene/scene.h"

namespace spherepair {

// A scene's name, or `aligned:8x16`.
SceneOptions parse_scene(const std::string& text, uint64_t seed);

std::string scene_label(const SceneOptions& options);  // aligned 8x16
json scene_json(const SceneOptions& options);

// Law, stiffness, drag, walls and units.
json contact_json(const ContactOptions& contact);

}  // namespace spherepair
