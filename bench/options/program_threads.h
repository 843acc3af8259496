// SPDX-License-Identifier: MIT
// The threads of a program that uses the CPU's backend: OpenMP's, which belong to the process.
#pragma once

namespace spherepair {

// Lets OpenMP's threads sleep while they wait for each other. By default they spin: where another program holds a core,
// each parallel region then waits for a thread that lost its core for as long as it spun before. The
// runtime reads the setting (OMP_WAIT_POLICY) as the program is loaded, so the program is started anew with it, once,
// unless its environment has it already. For the first line of main.
void wait_passively(char** argv);

// Starts the threads of all later parallel regions, as many as asked for or, for 0, one a core. Throws BackendError
// where the system lets fewer run. For the start of a program: where OpenMP's runtime (GCC's) cannot start a thread, it
// ends the process, with the exit code of a difference.
void start_team(int threads);

}  // namespace spherepair
