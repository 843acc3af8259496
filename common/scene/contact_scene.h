// SPDX-License-Identifier: MIT
// Contacts of a scene: stiffness, walls, time step and units chosen from its spheres, its checks and its parameters.
#pragma once

#include <algorithm>
#include <optional>
#include <ranges>

#include "common/scene/contact/contact_law.h"
#include "common/scene/motion_state.h"
#include "common/scene/scene_bounds.h"
#include "common/shared/contact/contact.h"

namespace spherepair {

struct ContactChoice {
  ContactLaw law = ContactLaw::none;
  std::optional<float> stiffness =
      {};  // of spheres of this density; none: such that the fastest sphere, falls included, enters by 1 % of a radius
  std::optional<float> dt = {};  // none: of the shortest contact, see default_steps
  float density = water;         // kg/m^3
  float drag = 0;                // in 1/s, see ContactOptions
  bool sleeping = true;
  bool walls = false;               // around the spheres as they stand, where the scene has none of its own ...
  std::optional<WallBox> box = {};  // ... or these, the lowest of which is the plane
};

// Sets the scene's contacts, its motion and its time step. Throws std::invalid_argument that names what is wrong.
void choose_contacts(Scene& scene, const ContactChoice& choice);

// Forces and energies over those of spheres of water.
inline double times_water(const Scene& scene) { return double(scene.contact.density) / double(water); }

std::optional<WallBox> box_of(const Scene& scene);  // that its walls close

Radii radii_of(const Scene& scene);

// A sphere's speed at the start, or after a fall onto the plane.
double highest_speed_of(const Scene& scene, uint64_t i);

// The speed that the default stiffness stops: the highest of all, but at least such that the weight of a largest sphere
// alone presses it in by 1 %. Where nothing moves, a smallest radius a second.
double highest_speed(const Scene& scene);

double farthest_coordinate(const vec4& sphere);

// The largest coordinate of spheres and walls.
double extent_of(const Scene& scene);

// The exponent of units in which a gap of the smallest radius is not cut off, see gap_of.
int coarsest_units(const Radii& radii);

// The sphere with the largest of(i).
template <typename Of>
uint64_t sphere_with_most(const Scene& scene, Of of) {
  return std::ranges::max(std::views::iota(uint64_t(0), scene.size()), {}, of);
}

constexpr double least_skin = 1.0 / 32, most_skin = 1;  // of a radius

// Whether units of length that reach to the farthest sphere and to the plane are fine enough for the smallest radius.
bool units_are_fine(const Scene& scene);

// The shortest contact that spheres from the smallest to the largest radius can have, in seconds; of hertz, whose
// contacts depend on the speed, at the highest.
double contact_time(const Scene& scene);

// Thickness of the skin around near spheres, in radii (skin.h): as thin as a list of pairs is short, but four times
// what rounding of the farthest centres may take of it. A run keeps that of its start.
float skin_of(const Scene& scene);

// Why a scene with contacts cannot be moved; empty where it can. Of a resumed one only what holds for the whole run.
std::string why_no_contacts(const Scene& scene, Origin origin = Origin::start);

ContactParams contact_params(const Scene& scene);

// Steps multiply by float32 factors made of radii, stiffness and time step. Says which of them would be 0 or infinite;
// empty if none would.
std::string why_beyond_float32(const Scene& scene);

// Whether spheres can come to rest to the bit and are then passed over: with drag, and no other way (NOTES/contacts).
inline bool may_sleep(const Scene& scene) { return scene.contact.drag > 0 && scene.contact.sleeping; }

// The spheres with radii grown by the skin, whose colliding pairs are those near enough to touch in many steps.
Scene grown_scene(const Scene& scene);

// Positions and momenta at the start, as SLOT_WIDE has them. Momenta are those half a step before the positions.
std::vector<uint> fixed_state(const Scene& scene);

// A sphere of such a state, all of them, and back.
inline Body load_body(const std::vector<uint>& wide, const std::vector<vec4>& positions, uint64_t i) {
  const uint64_t n = positions.size();
  const auto word = [&](uint64_t k) { return load_real<int64_t>(wide, k * n + i); };
  return {word(0), word(1), word(2), word(3), word(4), word(5), positions[i].w};
}

inline std::vector<Body> bodies_of(const std::vector<uint>& wide, const std::vector<vec4>& positions) {
  std::vector<Body> bodies;
  for (uint64_t i = 0; i < positions.size(); ++i) bodies.push_back(load_body(wide, positions, i));
  return bodies;
}

inline void store_body(std::vector<uint>& wide, uint64_t n, uint64_t i, const Body& s) {
  const int64_t values[6] = {s.x, s.y, s.z, s.px, s.py, s.pz};
  for (uint64_t k = 0; k < 6; ++k) store_real(wide, k * n + i, values[k]);
}

}  // namespace spherepair
