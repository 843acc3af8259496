// SPDX-License-Identifier: MIT
// Contacts of a scene: chooses stiffness, walls, time step and units from its spheres; checks; parameters.
#pragma once

#include <algorithm>
#include <optional>
#include <ranges>

#include "common/scene/contact/contact_law.h"
#include "common/scene/motion_state.h"
#include "common/scene/scene.h"
#include "common/shared/contact/contact.h"

namespace spherepair {

struct ContactChoice {
  ContactLaw law = ContactLaw::none;
  std::optional<float> stiffness =
      {};  // for this density; none: the fastest sphere, falls included, enters by 1 % of a radius
  std::optional<float> dt = {};  // seconds; none: a fraction of the shortest contact, see default_steps
  float density = water;         // kg/m^3
  float drag = 0;                // in 1/s, see ContactOptions
  bool sleeping = true;
  bool walls = false;               // close a box along the axes that are not periodic: the scene's ...
  std::optional<WallBox> box = {};  // ... or this one, else one around the spheres; with walls its floor is the plane
  uint periodic = 0;                // bits x, y, z: the scene's box or this one repeats along these axes, too
};

// Sets the scene's contacts, motion and time step. Throws std::invalid_argument that names what is wrong.
void choose_contacts(Scene& scene, const ContactChoice& choice);

// Sets their box alone, and wraps centres into it.
void choose_box(Scene& scene, const ContactChoice& choice);

// Wraps centres into the box along its periodic axes, rounded to float32; returns how many.
uint64_t wrap_centres(Scene& scene, const WallBox& box);

// Returns the density of the spheres in that of water. Forces and energies grow by this factor.
inline double times_water(const Scene& scene) { return double(scene.contact.density) / double(water); }

std::optional<WallBox> box_of(const Scene& scene);  // the box of its walls, or the one that repeats

Radii radii_of(const Scene& scene);

double speed(const vec4& velocity);

// Returns a sphere's speed after a fall from its start onto the plane, in m/s.
double highest_speed_of(const Scene& scene, uint64_t i);

// Returns the speed in m/s that the default stiffness stops: the highest of all spheres. It is at least the speed for
// which the weight of a largest sphere alone presses it in by 1 %. If nothing moves, it is a smallest radius a second.
double highest_speed(const Scene& scene);

double period_of(const Scene& scene, int axis);  // of its box, in metres; 0: not periodic

double farthest_coordinate(const vec4& sphere);

// Returns the largest absolute coordinate of spheres, walls and plane, in metres.
double extent_of(const Scene& scene);

// Returns the exponent of the coarsest units in which gap_of does not cut off a gap of the smallest radius.
int coarsest_units(const Radii& radii);

// Returns the sphere with the largest of(i).
template <typename Of>
uint64_t sphere_with_most(const Scene& scene, Of of) {
  return std::ranges::max(std::views::iota(uint64_t(0), scene.size()), {}, of);
}

constexpr double least_skin = 1.0 / 32, most_skin = 1;  // of a radius

// Whether units of length that reach the farthest sphere and the plane are fine enough for the smallest radius.
bool units_are_fine(const Scene& scene);

// Returns the shortest contact, in seconds, between spheres of the smallest to the largest radius; for hertz, whose
// contacts depend on the speed, at the highest speed.
double contact_time(const Scene& scene);

// Returns the thickness of the skin around near spheres, in radii (skin.h): as thin as keeps the list of pairs short,
// but at least four times the rounding error of the farthest centres. A run keeps the skin of its start.
float skin_of(const Scene& scene);

// Says why a scene with contacts cannot be moved; empty if it can. A resumed run is checked only for what holds
// throughout.
std::string why_no_contacts(const Scene& scene, Origin origin = Origin::start);

ContactParams contact_params(const Scene& scene);

// Says which of a step's float32 factors, made of radii, stiffness and time step, would be 0 or infinite; empty if none
// would.
std::string why_beyond_float32(const Scene& scene);

// Whether spheres can come to rest to the bit, so that steps skip them. Only drag does that (NOTES/contacts).
inline bool may_sleep(const Scene& scene) { return scene.contact.drag > 0 && scene.contact.sleeping; }

// Returns how long a box has to be along periodic axes: two spheres then touch through one image at most (periodic.h).
double least_period(const Scene& scene);

// Returns the spheres with radii grown by the skin. Their colliding pairs are the near pairs, which serve many steps.
Scene grown_scene(const Scene& scene);

// Returns positions and momenta at the start in the form of SLOT_WIDE. Momenta are half a step older than positions.
std::vector<uint> fixed_state(const Scene& scene);

// Convert one sphere, or all, from such a state, and back.
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
