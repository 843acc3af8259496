# SPDX-License-Identifier: MIT
"""The deliberate faults: what is replaced by what, where, and the ctest entries that should find it first."""


def mutant(name, file, old, new, *tests):
    return {"name": name, "file": file, "old": old, "new": new, "tests": list(tests)}


HARNESS = [
    mutant("fingerprints not compared", "bench/check/step_result.cpp", "l.fingerprint == r.fingerprint", "true", "Harness"),
    mutant("counts not compared", "bench/check/step_result.cpp", "left.counts == right.counts", "true", "Harness"),
    mutant("lists not compared", "bench/check/step_result.cpp", "*left.pairs == *right.pairs", "true", "Harness"),
    mutant("pair totals not compared", "bench/check/step_result.cpp", "l.pairs == r.pairs &&", "true &&", "Harness"),
    mutant("velocities not compared", "bench/check/step_result.cpp", 'compare(expected.velocities, found.velocities, "velocity");', "",
           "Harness"),
    mutant("wide state not compared", "bench/check/step_result.cpp", "if (l != expected.wide.end() || r != found.wide.end())",
           "if (false)", "Harness"),
    mutant("answers may contradict themselves", "bench/check/step_result.cpp", "require_consistent(point, reference, expected);", "",
           "Harness"),
    mutant("states of nobody compared", "bench/check/step_result.cpp", "if (backend.get() != &session.reference())",
           "if (backend.get() == nullptr)", "Harness"),
    mutant("a difference counts as equal", "bench/check/step_result.cpp", "if (!same_result(expected, found)) {",
           "if (false && !same_result(expected, found)) {", "Harness"),
    mutant("the list of others stays empty", "bench/check/lockstep.cpp", "found->others.push_back(configuration);", "", "Harness"),
    mutant("the grid is left out", "bench/check/lockstep.cpp", "if (!chosen(methods, method)) continue;",
           "if (!chosen(methods, method) || method == Method::collide_grid) continue;", "Harness"),
    mutant("the last step is not compared", "bench/check/lockstep.cpp",
           "return step % plan.every == 0 || step == plan.steps;", "return step % plan.every == 0;", "Harness"),
    mutant("guards are not checked", "bench/check/lockstep.cpp",
           "for (const auto& backend : session.backends()) backend->check_guards();", "", "Harness"),
    mutant("too few comparisons are enough", "bench/measure/comparisons.cpp", "counts.made[kind] != counts.planned[kind]",
           "counts.made[kind] > counts.planned[kind]", "Harness"),
    mutant("sets after a move are timed unchecked", "bench/tables/study.cpp", "moves ? 2 : 1", "1", "Timed"),
    mutant("a naive variant is checked as exact", "bench/tables/study.cpp", "exact.options.exact = true;", "", "Timed"),
    mutant("a study compares with itself", "bench/tables/study.cpp", "if (label(one) == label(reference)) continue;", "continue;",
           "Timed"),
    mutant("a sweep checks nothing", "bench/studies/sweep_point.cpp",
           "require_equal(session, {scene_of(point), 0}, reference, right, configuration, result);", "", "Timed"),
    mutant("a crossover checks nothing", "bench/studies/crossover_sweep.cpp", "for (const Way& way : ways) {\n    const Configuration configuration",
           "for (const Way& way : ways.empty() ? ways : std::vector<Way>()) {\n    const Configuration asked", "Timed"),
    mutant("a difference is recorded as equal", "bench/cli/compare.cpp", 'record.set("verdict", "difference");',
           'record.set("verdict", "equal");', "CompareProgram"),
    mutant("a difference exits with 0", "bench/cli/run_action.cpp", "return fail(kDifference,", "return fail(kOk,",
           "CompareProgram"),
    mutant("equal ignores states", "bench/check/equality.cpp", 'point.at("state").hex(16)', 'std::string("state")', "EqualProgram"),
    mutant("equal ignores fingerprints", "bench/check/equality.cpp", 'point.at("fingerprint").hex(32)',
           'point.at("fingerprint").hex(32).substr(0, 16)', "EqualProgram"),
    mutant("equal takes any verdict", "bench/check/equality.cpp", 'results.at("verdict").require("equal");', "", "EqualProgram"),
    mutant("equal takes fractions", "bench/check/equality.cpp", "is_number_unsigned()", "is_number()", "EqualProgram"),
    mutant("equal takes contradictions", "bench/check/equality.cpp", "if (!is_new && at->second != result_at(point))",
           "if (false)", "EqualProgram"),
    mutant("equal finds differences and exits with 0", "bench/cli/compare.cpp",
           "return result.differences.empty() ? kOk : kDifference;", "return kOk;", "EqualProgram"),
    mutant("samples begin where the last ended", "bench/measure/timing.cpp", "if (contender.restart) contender.restart(backend);", "", "Time", "Studies"),
]

SHADERS = [
    mutant("glsl: tile beyond the last sphere", "shaders/collide/collide_tiled.comp", "min(uint(BLOCK), p.n - first)", "uint(BLOCK)",
           "Methods", "Numbers"),
    mutant("glsl: undecided pairs dropped", "shaders/collide/collide.glsl", "if (verdict == UNDECIDED && i < j) defer(i, j);", "",
           "Methods", "Deferred"),
    mutant("glsl: second mix of swapped numbers", "shaders/collide/collide.glsl", "pair_mix_b(i, j)", "pair_mix_b(j, i)", "Methods"),
    mutant("glsl: carry of the totals lost", "shaders/collide/collide.glsl",
           "uint(value >> 32) + (before + low < before ? 1u : 0u)", "uint(value >> 32)", "Methods"),
    mutant("glsl: totals of one row lost", "shaders/collide/collide.glsl", "for (uint k = 0u; k < TOTAL_ROWS; ++k)",
           "for (uint k = 1u; k < TOTAL_ROWS; ++k)", "Methods"),
    mutant("glsl: triangle without its last column", "shaders/collide/collide_triangle.comp", "if (i < j && j < end)",
           "if (i < j && j + 1u < end)", "Methods"),
    mutant("glsl: one contact of a resolved pair", "shaders/collide/resolve_undecided.comp", "touch(pair.y, 1u);", "", "Deferred", "Methods"),
    mutant("glsl: tally misses single contacts", "shaders/collide/tally.comp", "count[i] != 0u", "count[i] > 1u", "Methods"),
    mutant("glsl: a row of cells left out", "shaders/collide/collide_grid.comp", "ahead && below, next - p.cells_x",
           "false, next - p.cells_x", "Methods", "GridProperties"),
    mutant("glsl: own row begins a sphere late", "shaders/collide/collide_grid.comp", "exists ? i + 1u : 0u", "exists ? i + 2u : 0u",
           "Methods", "GridProperties"),
    mutant("glsl: scan off by one", "shaders/grid/grid_scan.comp", "if (lane >= step)", "if (lane > step)", "Methods", "Oracle",
           "GridProperties"),
    mutant("glsl: hashed rows that share slots", "shaders/collide/collide_hashed.comp",
           "in_reach(mine, sphere) && stands_in_row(sphere, level, y, z, p)", "in_reach(mine, sphere)", "GridProperties",
           "StressCatalogue.Row1"),
    mutant("glsl: a bounce that is due is missed", "shaders/motion/bounce.comp", "if (now >= event_step.z", "if (now > event_step.z",
           "Motion"),
    mutant("glsl: motion of the last sphere", "shaders/motion/move.comp", "if (i >= p.n) return;", "if (i + 1u >= p.n) return;",
           "Motion"),
]

CPU = [
    mutant("cpu: second mix like the first", "common/cpu/search/cpu_pairs.cpp", "totals_.fingerprint.b += pair_mix_b(i, j);",
           "totals_.fingerprint.b += pair_mix_a(i, j);", "Methods"),
    mutant("cpu: undecided pairs dropped", "common/cpu/search/cpu_pairs.cpp",
           "if (verdict == UNDECIDED && !(search_.params.defer_undecided && settle(a, b))) return;",
           "if (verdict == UNDECIDED) return;", "Methods", "StressCatalogue.Row0"),
    mutant("cpu: counts of one side", "common/cpu/search/cpu_pairs.cpp", "++counts_[j];", "", "Methods"),
    mutant("cpu: pairs in no order", "common/backend/growing_list.h", "std::ranges::sort(all);", "", "Methods"),
    mutant("cpu: spheres beyond the last cell in runs", "common/cpu/search/cpu_grid_body.h",
           "if (is_last(run.cell.x) || is_last(run.cell.y) || is_last(run.cell.z)) return false;", "", "CpuGrid"),
    mutant("any scene moves", "common/cpu/cpu_motion.cpp", "if (!unmovable_.empty()) throw", "if (false) throw", "NonFinite"),
    mutant("a state may be infinite", "bench/check/finite_state.cpp", "if (unsound.empty()) return;", "return;", "NonFinite",
           "Harness"),
    mutant("cpu: columns beyond the tile", "common/cpu/search/cpu_pairs.cpp", "row < column && column < end", "row < column", "Methods"),
    mutant("cpu: rows of cells above left out", "common/cpu/search/cpu_grid_body.h", "for (; y <= high.y; ++y) test_row",
           "for (; y < high.y; ++y) test_row", "CpuGrid", "Methods"),
    mutant("cpu: half the reach of unequal radii", "common/cpu/search/cpu_pairs.cpp", "search.equal_radii ? 1.0f : 0.5f;",
           "search.equal_radii ? 1.0f : 0.25f;", "StressCatalogue.Row1", "Methods"),
    mutant("filter of equal radii too sure", "common/scene/scene_params.cpp", "const double margin = 12 * 0x1p-24",
           "const double margin = 1 * 0x1p-24", "Predicate", "StressCatalogue.Row0"),
    mutant("spheres reach half as many cells", "common/backend/grid_plan.cpp", "float(scale * double(plan.largest_radius) +",
           "float(scale * 0.5 * double(plan.largest_radius) +", "CpuGrid", "GridProperties"),
]

FILES = [
    mutant("npy pairs of the wrong width", "bench/formats/pair_file.cpp", "'{}u4'", "'{}u8'", "PairsCommand"),
    mutant("text pairs in one line", "bench/formats/pair_file.cpp", "text.push_back('\\n');", "text.push_back(' ');", "PairsCommand"),
    mutant("fortran order ignored", "bench/formats/npy_file.cpp", "header.fortran_order ? size : columns * size", "columns * size",
           "SphereFile"),
    mutant("big-endian numbers not swapped", "bench/formats/npy_file.cpp", "header.dtype[0] == foreign", "false", "SphereFile"),
    mutant("columns by name one too far", "bench/formats/xyz_columns.cpp", "columns.count += property->columns;",
           "columns.count += 1;", "SphereFile", "BadSphereFile"),
    mutant("a short frame is taken", "bench/formats/npy_file.cpp", "if (found < wanted)", "if (false)", "BadSphereFile"),
    mutant("negative radii are taken", "bench/formats/sphere_file.h", "is_radius && value < 0", "false && is_radius", "BadSphereFile"),
]

CHECKPOINT = [
    mutant("checksums are not compared", "bench/formats/checkpoint.cpp", "if (given != wanted)", "if (false)", "Checkpoint"),
    mutant("velocities are not saved", "bench/formats/checkpoint.cpp", 'visit("velocities", checkpoint.scene.velocities);',
           'visit("velocities", checkpoint.scene.positions);', "Checkpoint"),
    mutant("restitution is not restored", "bench/formats/checkpoint.cpp", "scene.restitution = header.restitution", "scene.restitution = 1",
           "Checkpoint"),
    mutant("save-every at wrong steps", "bench/cli/run.cpp", "step % options.save_every == 0", "step % options.save_every == 1",
           "NonFinite", "Checkpoint"),
    mutant("a killed run leaves half a file", "bench/io/replaced_file.cpp", "nameless_ = descriptor_ >= 0;",
           "nameless_ = descriptor_ >= 0; if (nameless_) { ::close(descriptor_); nameless_ = false; open_beside(); }",
           "ReplacedFile"),
]

COMMANDS = [
    mutant("an input may be an output", "bench/io/output_files.cpp", "if (other != uses_.end() &&", "if (false &&", "Outputs"),
    mutant("bytes reach the disk later", "bench/io/replaced_file.cpp",
           "if ((nameless_ || !beside_.empty()) && ::fsync(descriptor_) != 0) fail(errno);", "", "ReplacedFile"),
    mutant("NUL bytes are taken", "bench/io/file_lines.h", 'file.fail_at_line(uint64_t(lines_before) + 1, "text", "a NUL byte");',
           "", "ReadErrors"),
    mutant("a full device is no error", "bench/cli/run_action.cpp", "if (std::fflush(stdout) == 0 && !std::ferror(stdout))",
           "if (true)", "ExitCodes"),
    mutant("equal radii as the header says", "bench/formats/checkpoint_check.cpp",
           "(scene_.equal_radii && radius(i) != radius(0))", "false", "Checkpoint"),
]

EXACT = [
    mutant("float64 stage without its margin", "common/shared/exact.h", "q * bits_double(0x3FF00000u, 12u)",
           "q * bits_double(0x3FF00000u, 0u)", "Predicate"),
    mutant("wide integers lose their top word", "common/shared/exact.h", "uint words = (top - base + 57u) >> 5;",
           "uint words = (top - base + 25u) >> 5;", "Predicate", "StressCatalogue.Row0"),
]

MUTANTS = HARNESS + SHADERS + CPU + FILES + CHECKPOINT + COMMANDS + EXACT
