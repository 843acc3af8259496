// SPDX-License-Identifier: MIT
#include "bench/io/scene_text.h"

#include <fmt/format.h>

#include "bench/io/arguments.h"
#include "bench/io/numbers.h"

namespace spherepair {

SceneOptions parse_scene(const std::string& text, uint64_t seed) {
  SceneOptions options;
  options.seed = seed;
  options.name = text.substr(0, text.find(':'));
  std::vector<std::string> known;
  for (const SceneKind& kind : scene_kinds()) known.push_back(kind.name);
  require_known("scene", options.name, known);
  if (options.name == text) return options;
  const auto shape = two_numbers_of(text.substr(options.name.size() + 1), 'x', kMostSpheres);
  if (options.name != "aligned" || !shape)
    throw std::invalid_argument(fmt::format("scene '{}' is not an arrangement such as aligned:8x16", text));
  options.groups = uint((*shape)[0]);
  options.group_size = uint((*shape)[1]);
  options.n = uint64_t(options.groups) * options.group_size;
  return options;
}

std::string scene_label(const SceneOptions& o) {
  std::string text = o.name;
  if (o.groups) text += fmt::format(" {}x{}", o.groups, o.group_size);
  if (o.radius_ratio != 1) text += fmt::format(" radii 1:{}", o.radius_ratio);
  if (o.offset != 0) text += fmt::format(" at {}", o.offset);
  return text;
}

json scene_json(const SceneOptions& o) {
  json scene = {{"name", o.name},
                {"n", o.n},
                {"seed", o.seed},
                {"radius", o.radius},
                {"radius_ratio", o.radius_ratio},
                {"packing_fraction", o.packing_fraction},
                {"groups", o.groups},
                {"group_size", o.group_size},
                {"offset", o.offset}};
  // Only if not the default, so that records of versions without these options can be compared with new ones.
  const SceneOptions plain;
  if (o.motion != plain.motion) scene["motion"] = motion_label(o.motion);
  if (o.dt != plain.dt) scene["dt"] = o.dt;
  if (o.restitution != plain.restitution) scene["restitution"] = o.restitution;
  return scene;
}

json contact_json(const ContactOptions& contact) {
  if (contact.law == ContactLaw::none) return contact_name(contact.law);
  json record = {{"law", contact_name(contact.law)},
                 {"stiffness", double(contact.stiffness) * double(contact.density) / double(water)},
                 {"drag", contact.drag},
                 {"walls", contact.walls},
                 {"unit_exponent", contact.unit_exponent},
                 {"momentum_exponent", contact.momentum_exponent}};
  if (contact.periodic) record["periodic"] = axes_text(contact.periodic);
  if (contact.density != water) record["density"] = contact.density;  // earlier versions had only water
  return record;
}

}  // namespace spherepair
