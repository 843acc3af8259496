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
  uint8_t periodic[3]; /* 1: along this axis the box of `walls` repeats, without walls, and centres are wrapped into it.
                        * It must be longer than two diameters and some skin. If y is periodic, gravity must be 0 */
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

/* Writes a checkpoint to a file: all that later steps depend on. A file of that name is replaced once the new one is
 * whole. `spherepair run --resume` reads it, too. Fails with SP_E_ARGUMENT if the file cannot be written. */
SP_API sp_status sp_simulation_save(sp_simulation* simulation, const char* file);

/* Writes the same bytes to `bytes`, which has room for `room` of them. *size gets how many they are: equally many for
 * every state of a simulation. Fails with SP_E_CAPACITY, and writes only *size, if there is no room for them; bytes
 * may be NULL if room is 0. */
SP_API sp_status sp_simulation_save_bytes(sp_simulation* simulation, void* bytes, size_t room, size_t* size);

/* Opens a backend, named as for sp_open, and continues from a checkpoint. Any backend makes the same bits as a run
 * without interruption. The program's checkpoints continue with their own motion and count of steps. On failure *out
 * is NULL, and sp_simulation_message(NULL) has the reason: SP_E_ARGUMENT for a file that cannot be read, is no
 * checkpoint, or is cut off, damaged or inconsistent; the message names the byte or the sphere. */
SP_API sp_status sp_simulation_resume(const char* backend, const char* device, int32_t threads, const char* file,
                                      sp_simulation** out);
SP_API sp_status sp_simulation_resume_bytes(const char* backend, const char* device, int32_t threads, const void* bytes,
                                            size_t size, sp_simulation** out);

/* What an image shows. Set `size` to sizeof(sp_drawing), the rest to zero, then fill in what there is. Spheres whose
 * radius is below 2^-30 m or above 2^50 m, or that are farther away than that, are not drawn. */
typedef struct sp_drawing {
  size_t size;
  const double* eye;    /* 3 numbers, m: the place of the camera; NULL: where all spheres are in view */
  const double* target; /* 3 numbers, m: the point that it looks at; NULL: the centre of the spheres' bounding box */
  const double* up;     /* 3 numbers: its direction upwards; NULL: y */
  double azimuth;       /* without eye: degrees around `up`, -360 to 360; for y from +z to +x */
  double elevation;     /* without eye: degrees above the horizon, -90 to 90 */
  double field;         /* of view, from the lower to the upper edge, degrees, below 180; 0: 30 */
  double nearest;       /* m, least depth that is drawn; 0: a thousandth of the distance from eye to target */
  const char* color;    /* "contacts", "radius" or "speed"; NULL: contacts */
  const double* color_range; /* 2 numbers, 0 or more, ascending: radii in m or speeds in m/s with the first and the last
                              * colour; NULL: those of the spheres now */
  int32_t samples;           /* of each pixel, 1 to 1024; 0: 16 */
  int32_t plain;             /* not 0: without ambient occlusion, shadows and the ground */
  int32_t no_ground;         /* not 0: without the ground, which lies at the plane */
} sp_drawing;

/* Draws the spheres at their current positions, with the pixels of `spherepair render --no-box --no-legend`: the same
 * on every backend. pixels: H rows of 4 W columns, U8, in the host's memory: red, green, blue, alpha (255) of the W
 * pixels of a row, the upper row first. W and H are 1 to 16384. Strides are in bytes. Finds the pairs first, unless
 * neither light nor colours need them. */
SP_API sp_status sp_simulation_draw(sp_simulation* simulation, const sp_drawing* drawing, const sp_array* pixels);

SP_API uint64_t sp_simulation_spheres(const sp_simulation* simulation); /* how many there are: N */
SP_API double sp_simulation_dt(const sp_simulation* simulation);        /* seconds of a step */
SP_API uint64_t sp_simulation_steps(const sp_simulation* simulation);   /* made so far, before a checkpoint, too */

/* Why the last call failed. NULL: why this thread's last call failed that opens or resumes a simulation. */
SP_API const char* sp_simulation_message(const sp_simulation* simulation);

#ifdef __cplusplus
}
#endif
#endif
