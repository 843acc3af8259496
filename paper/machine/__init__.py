# SPDX-License-Identifier: MIT
"""What compilers made of the kernels: machine code of both APIs, and counters of the hardware."""
