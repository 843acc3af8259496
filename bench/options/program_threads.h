// SPDX-License-Identifier: MIT
// Sets up the process's OpenMP threads for the CPU backend.
#pragma once

namespace spherepair {

// Lets OpenMP's threads sleep while they wait for each other. By default they spin: if another program needs a core, a
// spinning thread loses it for whole time slices, and each parallel region waits for that thread. The runtime reads the
// setting (OMP_WAIT_POLICY) when the program is loaded, so this restarts the program once with it, unless the
// environment has it already. Call it in the first line of main.
void wait_passively(char** argv);

// Starts `threads` threads for all later parallel regions; 0: one a core. Throws BackendError if the system allows
// fewer. Call it at the start of a program: if OpenMP's runtime (GCC's) cannot start a thread, it ends the process,
// with the exit code of a difference.
void start_team(int threads);

}  // namespace spherepair
