// SPDX-License-Identifier: MIT
// Scenes: where spheres start. Every random number is an integer hash of (seed, index), so a scene has the same bits on
// every machine and with every compiler.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/scene/contact/contact_options.h"
#include "common/scene/motion_options.h"
#include "common/shared/layout.h"

namespace spherepair {

// From this many spheres on, several threads share the work: little for each sphere, or as much as its motion takes.
constexpr uint64_t many_spheres = 1 << 16, many_moves = 4096;

// n spheres: positions in metres with the radius in w, velocities in metres per second.
struct Scene {
  std::string name;
  std::vector<vec4> positions = {}, velocities = {};
  float plane = -5.0f;       // height of the ground
  float gravity = -9.81f;    // along y, metres per second squared
  float dt = 0x1p-6f;        // seconds; a power of two keeps v*dt exact
  float restitution = 1.0f;  // 0..1
  bool equal_radii = true;   // all radii have equal bits
  MotionOptions motion = {};
  ContactOptions contact = {};  // chosen by choose_contacts (contact_scene.h)

  uint64_t size() const { return positions.size(); }
};

struct SceneOptions {
  std::string name = "random";
  uint64_t n = 16384;
  uint64_t seed = 20251121;
  float radius = 0.5f;
  float radius_ratio = 1.0f;        // largest radius over smallest; radii are log-uniform in between
  double packing_fraction = 0.3;    // of `uniform`
  uint groups = 0, group_size = 0;  // of `aligned`: the paper's m x n; 0 x 0: groups of 128 or fewer
  float offset = 0.0f;              // added to every coordinate of every centre
  MotionOptions motion = {};
  float dt = 0x1p-6f, restitution = 1.0f;
};

struct SceneKind {
  const char* name;
  const char* summary;
};
const std::vector<SceneKind>& scene_kinds();

// Both throw std::invalid_argument that names the wrong option and its allowed values.
void check_options(const SceneOptions& options);
Scene make_scene(const SceneOptions& options);

// Throws std::invalid_argument if a number is not finite or a radius is negative: how many, the first one's index and
// why. For scenes that move, the first move also checks bounds on numbers, time step, restitution and gravity
// (why_unmovable).
void check_scene(const Scene& scene);

// Which numbers a scene may hold: any finite ones while it is at rest, bounded ones if it moves, since motion
// multiplies them. Within the bounds every motion method stays finite for 2^40 steps.
constexpr float shortest_step = 0x1p-60f, longest_step = 0x1p20f;  // seconds: of dt
constexpr float largest_number = 0x1p60f;  // of coordinates, radii, speeds, gravity and the height of the plane

// Says how many spheres have a NaN, an infinity or a negative radius, and which is the first; empty if none has.
std::string unsound_spheres(const std::vector<vec4>& positions, const std::vector<vec4>& velocities);

// Says why a scene that check_scene accepts cannot be moved; empty if it can. A resumed run may be faster, farther out
// and larger than a scene may start: it is refused in the step that cannot be made.
enum class Origin { start, resumed };
std::string why_unmovable(const Scene& scene, Origin origin = Origin::start);

// Returns the number of spheres that stall: along some axis the velocity is not 0, but a step changes no bit of the
// float32 position. Other precisions and `anchored` give 0.
uint64_t stalled_spheres(const Scene& scene);

// Returns a 64-bit hash of the bits of all positions and velocities, in order, and of the words of a wide state.
uint64_t state_hash(const std::vector<vec4>& positions, const std::vector<vec4>& velocities,
                    const std::vector<uint>& wide = {});

}  // namespace spherepair
