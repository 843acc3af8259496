/* SPDX-License-Identifier: MIT
 *
 * Spheres that move: they fall, bounce off a plane or walls, and push each other or pass through each other.
 *
 * Lengths are in metres, times in seconds, masses in kilograms. y points up; the plane is horizontal. A step gives the
 * same bits on every backend.
 *
 * Without contacts spheres pass through each other. Each flies on a parabola and bounces off the plane; nothing is
 * rounded between two bounces (the motion `anchored` of docs/motion.md). With contacts (docs/contacts.md) the force on
 * two spheres lies along the line of their centres. o is how far they overlap:
 *
 *     spring   k o, with a damper where the restitution is below 1;  k in N/m
 *     hertz    k o^1.5, elastic;                                     k in N/m^1.5
 *     quartic  k (R^2 - d^2) d, elastic; R is the sum of the radii and d the distance of the centres; k in N/m^3
 *
 * Steps are those of the leapfrog, in 64-bit integers.
 *
 * A simulation has a backend of its own. One thread at a time uses it; several can be used at once.
 */
#ifndef SPHEREPAIR_SIMULATION_H
#define SPHEREPAIR_SIMULATION_H

#include <spherepair/spherepair.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Where spheres start. Set `size` to sizeof(sp_scene), the rest to zero, then fill in what there is. */
typedef struct sp_scene {
  size_t size;
  sp_array positions;  /* N x 3, F32 or F64: centres. F64 is rounded to the nearest F32 */
  sp_array velocities; /* N x 3, F32 or F64, in m/s; none: all at rest */
  sp_array radii;      /* N, F32 or F64, not negative; with contacts above 0 */
  double plane;        /* height of the plane; no sphere may reach below it, with contacts no centre */
  double gravity;      /* m/s^2, downwards: 9.81 on the earth */
  double restitution;  /* speed after a bounce over the speed before, 0 to 1; 1 with `hertz` and `quartic` */
  double dt;           /* seconds of a step; 0: 1/64, with contacts a fraction of the shortest contact */

  const char* contact; /* "spring", "hertz" or "quartic"; NULL or "none": spheres pass through each other */
  double stiffness; /* k; 0: chosen so that the fastest sphere, after its fall, overlaps another by 1 % of a radius */
  double density;   /* kg/m^3; 0: 1000, water */
  double drag;      /* of a fluid at rest: speeds alone fall to 1/e in 1/drag seconds; 0: none */
  sp_array walls; /* 2 x 3, F32 or F64: the lowest and the highest corner of a closed box, whose floor is the plane and
                   * replaces `plane`; none: no walls. With contacts only */
} sp_scene;

typedef struct sp_simulation sp_simulation;

/* Opens a backend, named as for sp_open, and puts the scene on it. On failure *out is NULL, and
 * sp_simulation_message(NULL) has the reason. */
SP_API sp_status sp_simulation_open(const char* backend, const char* device, int32_t threads, const sp_scene* scene,
                                    sp_simulation** out);
SP_API void sp_simulation_close(sp_simulation* simulation); /* NULL is fine */

/* Makes `steps` steps. Fails with SP_E_ARGUMENT if a sphere gets too fast, too far away or too deep into another; the
 * message names the sphere and says what to do. After that all calls but sp_simulation_close fail. */
SP_API sp_status sp_simulation_move(sp_simulation* simulation, uint64_t steps);

/* Writes the state, rounded to F32, into N x 3 arrays of F32 or F64. NULL: not wanted. */
SP_API sp_status sp_simulation_state(sp_simulation* simulation, const sp_array* positions, const sp_array* velocities);

/* Lists the pairs i < j of spheres that overlap now, sorted: columns first and second. sp_free frees the list. */
SP_API sp_status sp_simulation_pairs(sp_simulation* simulation, sp_pairs** out);

SP_API double sp_simulation_dt(const sp_simulation* simulation);      /* seconds of a step */
SP_API uint64_t sp_simulation_steps(const sp_simulation* simulation); /* made so far */

/* Why the last call failed. NULL: why this thread's last sp_simulation_open failed. */
SP_API const char* sp_simulation_message(const sp_simulation* simulation);

#ifdef __cplusplus
}
#endif
#endif
