/* SPDX-License-Identifier: MIT
 *
 * Lists of pairs: neighbours within a cutoff, or spheres that overlap; open and periodic boxes; one system or many.
 *
 * What a pair is. A pair is (i, j, S): the points i and j, and S, three integers that say which image of j. It is in
 * the list if and only if
 *
 *     |x_j - x_i + S_0 H_0 + S_1 H_1 + S_2 H_2|^2  <  c^2,
 *
 * decided in real arithmetic on the numbers as they are given: no coordinate, radius or cutoff is rounded first. H_k
 * are the rows of the box. c is the cutoff, or r_i + r_j where there are radii, plus the skin. With `inclusive` equal
 * numbers are a pair, too. S refers to the coordinates as they are given, which need not lie in the box; along an axis
 * that is not periodic it is 0. Two points at one place are a pair if c > 0.
 *
 * A full list has (i, j, S) and (j, i, -S). A half list has the one with i < j; of an image of the point itself
 * (i = j) the one whose first component of S other than 0 is positive. (i, i, 0) is in the list only with `self_pairs`,
 * and then if 0 < c^2 (with `inclusive` always).
 * Lists are sorted by i, then j, then S_0, S_1, S_2. They are equal bit for bit on every backend.
 *
 * Units: one unit of length for positions, radii, boxes, cutoff and skin; which one is the caller's choice.
 * Indices start at 0 and have 32 bits, numbers of pairs 64.
 *
 * Threads: a context is used by one thread at a time; several contexts can be used at once. Nothing else is shared.
 */
#ifndef SPHEREPAIR_H
#define SPHEREPAIR_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define SP_API __attribute__((visibility("default")))
#else
#define SP_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define SP_ABI_VERSION 2 /* changes when a struct or the meaning of a call changes */

typedef enum sp_status {
  SP_OK = 0,
  SP_E_ARGUMENT,  /* an argument that the call cannot take: its shape, type or sign, or a missing pointer */
  SP_E_NONFINITE, /* a NaN or an infinity among the numbers; the message names the first */
  SP_E_RANGE,     /* a number other than 0 whose size is not from 2^-450 to 2^450; a point more than 2^30 boxes away
                   * from the box at the origin; more points than 2^31 - 1, or more images of them within reach than 2^27 */
  SP_E_CAPACITY,  /* the caller's arrays are too short; `count` says how many rows are needed, of offsets one more than
                   * there are points */
  SP_E_MEMORY,    /* out of memory, on the host or on the device */
  SP_E_BACKEND    /* no such backend here, or the driver failed; the message has the reason */
} sp_status;

typedef enum sp_type { SP_F32 = 0, SP_F64, SP_I32, SP_I64, SP_U8 } sp_type;

/* An array of one or two dimensions that the caller owns. Element (row, column) is at
 * data + (row * row_stride + column * column_stride) elements of `type`. One dimension: columns is 1.
 * All zero: no array. */
typedef struct sp_array {
  void* data;
  int64_t rows, columns;
  int64_t row_stride, column_stride; /* in elements, may be negative */
  int32_t type;                      /* sp_type */
  int32_t device_type, device_id;    /* as DLPack has them: 1 is the host's memory, 2 is CUDA's; see sp_problem */
} sp_array;

/* Positions in CUDA's memory stay there: a context of cuda reads them, with radii and queries, and writes columns, all
 * in its device's memory and in `stream`. boxes, periodic, offsets, query_offsets and exclusions may lie in either
 * memory. Each call copies those in CUDA's to the host and waits for them, sp_fill with `found` too: to wait for
 * nothing, keep them in the host's memory. */

/* The problem: which pairs to list. Set `size` to sizeof(sp_problem), the rest to zero, then fill in what there is. */
typedef struct sp_problem {
  size_t size;
  sp_array positions; /* N x 3, F32 or F64 */
  sp_array radii;     /* N, F32 or F64, not negative; none: the cutoff is for all */
  double cutoff;      /* not negative; 0 where there are radii */
  double skin;        /* added to r_i + r_j or to the cutoff; not negative */

  /* Boxes: B x 9 of F32 or F64, the rows H_0, H_1, H_2 of each system's box one after another; a row along which the
   * system is not periodic is not read. Left-handed and tilted boxes and boxes shorter than the cutoff are fine.
   * periodic: B x 3 of U8, 0 or 1. Neither: open. With one box for several systems, all have it. */
  sp_array boxes, periodic;

  /* Several systems in one call: the points of system b are offsets[b] to offsets[b + 1] - 1. B + 1 of I64 or I32 that
   * ascend from 0 to N; none: one system. No pair joins two systems. */
  sp_array offsets;

  /* One set against another: pairs (i, j, S) of query i and point j, as a full list; `half` and `self_pairs` are 0.
   * Queries have radii if and only if points do, and offsets likewise. */
  sp_array queries, query_radii, query_offsets;

  /* Pairs to leave out with every S: E x 2 indices, I32 or I64, in either order; of query and point where there are
   * queries. */
  sp_array exclusions;

  int32_t half, inclusive, self_pairs; /* 0 or 1 */
  void* stream; /* the cudaStream_t in which arrays in CUDA's memory are used; NULL: the default stream */
} sp_problem;

/* The columns of a list. All but offsets have `count` rows. */
typedef struct sp_pairs {
  size_t size;        /* sizeof(sp_pairs) */
  int64_t count;      /* pairs in the list */
  sp_array first;     /* I32 or I64: i */
  sp_array second;    /* I32 or I64: j */
  sp_array shifts;    /* count x 3, I32 or I64: S */
  sp_array vectors;   /* count x 3, F64: x_j - x_i + S H, each component at most 1 unit in the last place off */
  sp_array distances; /* F64: the length of the vector; its relative error is below 2^-50 */
  sp_array offsets;   /* I64, one row more than points or queries: i has rows offsets[i] to offsets[i + 1] - 1 */

  /* For sp_fill with positions in CUDA's memory: one I64 there, which gets the number of pairs. See sp_fill. */
  sp_array found;
} sp_pairs;

/* The columns that sp_list adds to first and second: a sum of these. */
enum { SP_SHIFTS = 1, SP_VECTORS = 2, SP_DISTANCES = 4, SP_OFFSETS = 8 };

typedef struct sp_context sp_context; /* a backend on a device, opened */

SP_API uint32_t sp_abi_version(void); /* SP_ABI_VERSION of the library that is loaded */
SP_API const char* sp_version(void);  /* "0.3.0" */

/* The name of a backend that this version knows: "cpu", "opengl", "cuda", "vulkan"; NULL behind the last. */
SP_API const char* sp_backend_name(int32_t index);

/* Opens a backend by its name; "auto": the first of cuda, vulkan, opengl on a GPU, else cpu. device: a GPU's number or
 * UUID, or NULL. threads: of cpu; 0: one a core. On failure *out is NULL and sp_message(NULL) has the reason. */
SP_API sp_status sp_open(const char* backend, const char* device, int32_t threads, sp_context** out);
SP_API void sp_close(sp_context* context);                /* NULL is fine. Lists that it made stay valid */
SP_API const char* sp_backend(const sp_context* context); /* the name of the opened backend; valid until sp_close */
SP_API const char* sp_device(const sp_context* context);  /* its device, as the driver names it */

/* Why the context's last call failed; valid until its next call. NULL: why this thread's last sp_open failed. */
SP_API const char* sp_message(const sp_context* context);

/* Counts the pairs of the list. */
SP_API sp_status sp_count(sp_context* context, const sp_problem* problem, int64_t* count);

/* Makes the list in new memory, which sp_free frees. If the positions are in CUDA's memory, so is the list, complete
 * once the stream reaches that point. wanted: a sum of SP_SHIFTS ... On failure *out is NULL. */
SP_API sp_status sp_list(sp_context* context, const sp_problem* problem, uint32_t wanted, sp_pairs** out);
SP_API void sp_free(sp_pairs* list); /* NULL is fine */

/* Writes the list into the caller's arrays: those of `pairs` that have data, each of at least `count` rows. `count` is
 * set in any case; if an array has fewer rows, nothing is written but `found`, and the status is SP_E_CAPACITY.
 * Columns of I32 without gaps in CUDA's memory are written by the search itself; for others it allocates a copy.
 *
 * With `found` a call neither waits nor allocates if the context's last call had the same problem, except for the
 * numbers in positions, radii and queries, and columns of as many rows, and if no boxes, periodic, offsets or
 * exclusions lie in CUDA's memory. Such a call can be captured into a CUDA graph, which can be replayed until the
 * context's next call with another problem or number of rows. `count` is then -1, and `found` gets the number of pairs
 * once the stream reaches that point. If it is more than the rows of a column, no pair was written. If it is -1 - i,
 * the numbers of position i, or of query i - N, cannot be listed. INT64_MIN: call once without `found`.
 */
SP_API sp_status sp_fill(sp_context* context, const sp_problem* problem, sp_pairs* pairs);

#ifdef __cplusplus
}
#endif
#endif
