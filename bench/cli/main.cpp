// SPDX-License-Identifier: MIT
#include "bench/cli/command_line.h"

int main(int argc, char** argv) { return spherepair::run_program(argc, argv); }
