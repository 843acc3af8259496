# SPDX-License-Identifier: MIT
"""Deliberate faults of the lists of pairs and of the library's calls."""
from mutant import mutant

LISTS = [
    mutant("a filter without the bound of its roundings", "common/lists/displacement.cpp",
           "error += (2 * std::abs(way) + off) * off;", "", "Lists"),
    mutant("pairs join two systems", "common/lists/pair_list.cpp", "problem_.asks || plan_.systems[pair.second] != system",
           "problem_.asks", "Lists"),
    mutant("shifts are left out of exact sums", "common/lists/displacement.cpp",
           "if (pair.shift[k] != 0) sum.add_product(pair.shift[k], box.rows[k][axis]);", "", "Lists"),
    mutant("inclusive lists lack their ties", "common/lists/displacement.cpp", "(side == 0 && problem.inclusive)", "false", "Lists"),
    mutant("images reach half as far", "common/lists/lattice.cpp", "spans[k] = distance *", "spans[k] = 0.5 * distance *", "Lists"),
    mutant("shifts are of wrapped coordinates", "common/lists/pair_list.cpp",
           "sum(image.shift, less(plan_.first_cells[pair.first], plan_.cells[image.point]))", "image.shift", "Lists"),
    mutant("half lists have both images of a point", "common/lists/pair_list.cpp",
           "(one.first == one.second && one.shift < Shift{})", "false", "Lists"),
    mutant("exclusions are in the order given", "common/lists/pair_list.cpp",
           "if (!problem_.asks && ids.first > ids.second) std::swap(ids.first, ids.second);", "", "Lists"),
    mutant("spheres are as large as in real numbers", "common/lists/list_spheres.cpp", "+ 0x1p-25;", ";", "Lists"),
    mutant("a call keeps its OpenGL context", "glsl/gl_device.cpp", "noexcept override { context_.leave(); }", "noexcept override {}",
           "CCalls"),
    mutant("too short columns are written", "api/c/library.cpp", "if (!context->message.empty()) return SP_E_CAPACITY;", "", "CCalls"),
    mutant("strides of columns are ignored", "api/c/arrays.h", "column * array.column_stride", "column", "CCalls"),
    mutant("a Lattice is read by columns", "bench/spheres/xyz_columns.cpp", "box.rows[k / 3][k % 3]", "box.rows[k % 3][k / 3]",
           "PeriodicPairs"),
    mutant("pbc is ignored", "bench/spheres/xyz_columns.cpp", "axes.empty() || *axes[k]", "true", "PeriodicPairs"),
    mutant("a simulation's gravity points up", "api/c/simulation.cpp", "0 - rounded(given.gravity", "rounded(given.gravity", "SimulationCalls"),
    mutant("a simulation goes on after a failed step", "api/c/simulation.cpp", "simulation->failed = true;", "simulation->failed = false;",
           "SimulationCalls"),
    mutant("a simulation's walls are left out", "api/c/simulation.cpp", "choice.walls = is_given(given.walls);", "choice.walls = false;",
           "SimulationCalls"),
    mutant("a simulation has no drag", "api/c/simulation.cpp", 'choice.drag = rounded(given.drag, "drag");', "choice.drag = 0;", "SimulationCalls"),
]
