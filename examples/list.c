/* SPDX-License-Identifier: MIT
 *
 * Neighbours in C: the points of a 4 x 4 x 4 grid whose distance is below 1.1 times its spacing, each pair once.
 * Prints the number of pairs, which is 144, and the first three with their distances. */
#include <inttypes.h>
#include <spherepair/spherepair.h>
#include <stdio.h>

#define SIDE 4
#define POINTS (SIDE * SIDE * SIDE)

static void print_first(const sp_pairs* list, int64_t rows) {
  const int32_t *i = list->first.data, *j = list->second.data;
  const double* distance = list->distances.data;
  for (int64_t row = 0; row < rows && row < list->count; ++row)
    printf("%" PRId32 " - %" PRId32 ": %g\n", i[row], j[row], distance[row]);
}

int main(void) {
  double positions[POINTS][3];
  for (int n = 0; n < POINTS; ++n) {
    positions[n][0] = n / (SIDE * SIDE);
    positions[n][1] = n / SIDE % SIDE;
    positions[n][2] = n % SIDE;
  }

  sp_problem problem = {0};
  problem.size = sizeof problem;
  /* POINTS rows of 3 numbers; 3 numbers from row to row, 1 from column to column; 1: in the host's memory. */
  problem.positions = (sp_array){positions, POINTS, 3, 3, 1, SP_F64, 1, 0};
  problem.cutoff = 1.1;
  problem.half = 1;

  sp_context* context = NULL;
  if (sp_open("cpu", NULL, 0, &context) != SP_OK) {
    fprintf(stderr, "cannot open the CPU backend: %s\n", sp_message(NULL));
    return 1;
  }
  sp_pairs* list = NULL;
  if (sp_list(context, &problem, SP_DISTANCES, &list) != SP_OK) {
    fprintf(stderr, "cannot list the pairs: %s\n", sp_message(context));
    sp_close(context);
    return 1;
  }
  const int64_t count = list->count;
  printf("%" PRId64 " pairs\n", count);
  print_first(list, 3);
  sp_free(list);
  sp_close(context);
  return count == 3 * SIDE * SIDE * (SIDE - 1) ? 0 : 1; /* along each of 3 axes */
}
