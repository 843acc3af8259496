// SPDX-License-Identifier: MIT
#include "program.h"

int main(int argc, char** argv) { return spherepair::run_program(argc, argv); }
