/* SPDX-License-Identifier: MIT
 *
 * Lists in CUDA's memory: the points of a 4 x 4 x 4 grid and the columns stay on the GPU, and the search is captured
 * into a graph, which is replayed for a grid twice as wide. Prints the two numbers of pairs, 144 and 0. Exits with 77
 * where there is no CUDA device. */
#include <cuda_runtime_api.h>
#include <inttypes.h>
#include <spherepair/spherepair.h>
#include <stdio.h>

#define SIDE 4
#define POINTS (SIDE * SIDE * SIDE)
#define ROOM 1000 /* pairs */

static void write_grid(double* positions, double spacing) {
  double points[POINTS][3];
  for (int n = 0; n < POINTS; ++n) {
    points[n][0] = spacing * (n / (SIDE * SIDE));
    points[n][1] = spacing * (n / SIDE % SIDE);
    points[n][2] = spacing * (n % SIDE);
  }
  cudaMemcpy(positions, points, sizeof points, cudaMemcpyHostToDevice);
}

static int64_t replay(cudaGraphExec_t graph, cudaStream_t stream, const int64_t* found) {
  int64_t pairs = -1;
  cudaGraphLaunch(graph, stream);
  cudaStreamSynchronize(stream);
  cudaMemcpy(&pairs, found, sizeof pairs, cudaMemcpyDeviceToHost);
  return pairs;
}

int main(void) {
  sp_context* context = NULL;
  if (sp_open("cuda", NULL, 0, &context) != SP_OK) {
    fprintf(stderr, "cannot open CUDA: %s\n", sp_message(NULL));
    return 77;
  }
  double* positions = NULL;
  int32_t* columns = NULL;
  int64_t* found = NULL;
  cudaStream_t stream;
  cudaMalloc((void**)&positions, POINTS * 3 * sizeof(double));
  cudaMalloc((void**)&columns, 2 * ROOM * sizeof(int32_t));
  cudaMalloc((void**)&found, sizeof(int64_t));
  cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking);
  write_grid(positions, 1);

  sp_problem problem = {0};
  problem.size = sizeof problem;
  problem.positions = (sp_array){positions, POINTS, 3, 3, 1, SP_F64, 2, 0}; /* 2: in CUDA's memory */
  problem.cutoff = 1.1;
  problem.half = 1;
  problem.stream = stream;
  sp_pairs pairs = {0};
  pairs.size = sizeof pairs;
  pairs.first = (sp_array){columns, ROOM, 1, 1, 1, SP_I32, 2, 0};
  pairs.second = (sp_array){columns + ROOM, ROOM, 1, 1, 1, SP_I32, 2, 0};
  pairs.found = (sp_array){found, 1, 1, 1, 1, SP_I64, 2, 0};

  /* The first call allocates; the second waits for nothing and is captured. */
  cudaGraph_t graph = NULL;
  cudaGraphExec_t captured = NULL;
  sp_status status = sp_fill(context, &problem, &pairs);
  cudaStreamBeginCapture(stream, cudaStreamCaptureModeThreadLocal);
  if (status == SP_OK) status = sp_fill(context, &problem, &pairs);
  cudaStreamEndCapture(stream, &graph);
  int64_t near = -1, far = -1;
  if (status == SP_OK && cudaGraphInstantiate(&captured, graph, 0) == cudaSuccess) {
    near = replay(captured, stream, found);
    write_grid(positions, 2);
    far = replay(captured, stream, found);
    cudaGraphExecDestroy(captured);
  }
  if (status != SP_OK) fprintf(stderr, "cannot list the pairs: %s\n", sp_message(context));
  printf("%" PRId64 " pairs, then %" PRId64 "\n", near, far);
  if (graph) cudaGraphDestroy(graph);
  sp_close(context);
  cudaStreamDestroy(stream);
  cudaFree(found);
  cudaFree(columns);
  cudaFree(positions);
  return near == 3 * SIDE * SIDE * (SIDE - 1) && far == 0 ? 0 : 1;
}
