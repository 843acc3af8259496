# SPDX-License-Identifier: MIT
"""Neighbours in Python: the points of a 4 x 4 x 4 grid whose distance is below 1.1 times its spacing, each pair once.

Prints the number of pairs, 144 in the open and 192 in a periodic box, and the first three with their distances. numpy
is not needed.
"""

import sys

import spherepair

SIDE = 4
positions = [[float(x), float(y), float(z)] for x in range(SIDE) for y in range(SIDE) for z in range(SIDE)]

i, j, distances = spherepair.neighbor_list("ijd", positions, cutoff=1.1, half=True, backend="cpu")
print(len(i), "pairs")
for row in range(3):
    print(f"{i[row]} - {j[row]}: {distances[row]:g}")

periodic = spherepair.neighbor_list("i", positions, cutoff=1.1, cell=[SIDE] * 3, half=True, backend="cpu")
print(len(periodic), "pairs in a periodic box")
sys.exit(0 if (len(i), len(periodic)) == (144, 192) else 1)
