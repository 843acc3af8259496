# SPDX-License-Identifier: MIT
"""Numbers of the prose about errors: of the motion, of the sets that follow from it, and of the stress catalogue."""
import re

from paper.numbers.derived import copy_rate
from paper.numbers.pareto import paper_setting, seconds, study
from paper.numbers.sets import sets, wrong
from paper.numbers.stress import places, recorded_stress, stressed
from paper.records import Missing, said
from paper.text import ms

DEVICES = ("opengl", "cuda")


def errors_of_motion(put, machine, others):
    """The original's method and anchored flights: alone, and with positions evaluated in every step."""
    for name in DEVICES:
        rows = study(machine, backend=name)
        paper, = paper_setting(rows)
        anchored = {(row.precision, row.work, row.dt): row for row in rows if row.method == "anchored"}
        same, longest = paper.dt, max(row.dt for row in rows)
        for key, row in (("paper", paper), ("anchored", anchored["float32", "move", same]),
                         ("evaluated", anchored["float32", "move and evaluate", same]),
                         ("longer", anchored["float32", "move and evaluate", longest]),
                         ("exact", anchored["float64", "move", same])):
            better = seconds(row) < seconds(paper) and row.error_m < paper.error_m
            said(machine, better or key in ("paper", "evaluated"), f"{row.label} is faster and more accurate on {name}")
            what = f"{row.method}, {row.precision}, {row.work}, step {row.dt:g} s"
            put(f"motion/{key}/ns/{name}", f"{seconds(row):.2f}", row.source, f"ns per sphere and simulated second, {name}, {what}")
            put(f"motion/{key}/error/{name}", scientific(row.error_m), row.source, f"rms error in m, {name}, {what}")


def scientific(value):
    """As mathematics if a decimal would be long."""
    if value >= 0.01:
        return f"{value:.2f}"
    digits, exponent = f"{value:.1e}".split("e")
    return f"${digits} \\cdot 10^{{{int(exponent)}}}$"


def bandwidth(record, backend):
    """Bytes per second of a step of `paper` in float32, in a record of `precision`."""
    step = next(row for row in record["times"]
                if (row["method"], row["precision"], row["work"], row["backend"]) == ("paper", "float32", "move", backend))
    return step["bytes_per_sphere_step"] / step["seconds_per_sphere_step"]


def motion_at_scale(put, machine, others):
    """A step of more spheres than fit any cache, and its share of the copy bandwidth."""
    record = machine.source("precision_1e8.json")
    put("motion/large/n", f"{record['settings']['time_n']:,}", record["id"], "spheres of the largest timed motion")
    for name in DEVICES:
        wanted = {"table": "precision", "backend": name, "precision": "float32", "n": record["settings"]["time_n"]}
        rows = {(row.method, row.work): row for row in machine.need(**wanted)}
        paper, anchored = rows["paper", "move"], rows["anchored", "move"]
        share = bandwidth(record, name) / copy_rate(machine)
        for row in (paper, anchored):
            put(f"motion/large/{row.method}/{name}", ms(row.median), row.source, f"ms per step, {name}, {row.method}")
        said(machine, share > 0.9, f"memory bounds the original's motion on {name}")
        gain = paper.median / anchored.median
        put(f"motion/large/gain/{name}", f"{gain:.1f}", paper.source, f"{name}, the ratio of both")
        put(f"motion/large/share/{name}", f"{100 * share:.0f}", record["id"],
            f"{name}, bandwidth of the original's motion over the highest copy rate recorded, in %")
        put(f"motion/large/bounce/{name}", f"{100 * paper.bouncing:.1f}", paper.source, "% that bounce in the step")


def wrong_sets(put, machine, others):
    root = sets(machine)
    source = root["id"]
    put("sets/seconds", f"{root['settings']['seconds']:g}", source, "simulated seconds before the sets are compared")
    put("sets/n", f"{root['settings']['n']:,}", source, "spheres")
    near = {(e["method"], e["precision"], e["k"]): e for e in root["motion"] if e["offset"] == 0}
    for k in sorted({k for _, _, k in near}):
        for method in ("paper", "anchored"):
            entry = near[method, "float32", k]
            put(f"sets/{method}/{k}", f"{entry['missed'] + entry['extra']:,}", source,
                f"pairs missed or extra, {method}, float32, step 2^-{k} s")
            put(f"sets/{method}/{k}/percent", percent(wrong(entry)), source, "the same in % of the right pairs")
    put("sets/right", f"{near['paper', 'float32', k]['right']:,}", source, "right pairs")
    farthest = max(e["offset"] for e in root["storage"])
    put("sets/far/m", in_words(farthest), source, "greatest distance from the origin, m")
    for precision in ("float32", "compensated", "float64"):
        entry, = (e for e in root["storage"] if (e["precision"], e["offset"]) == (precision, farthest))
        put(f"sets/far/{precision}", percent(wrong(entry)), source, f"% of pairs wrong, stored in {precision} there")
    said(machine, not any(entry["swept_missed"] for entry in root["contacts"]), "the swept test misses no contact")
    fast = max(root["contacts"], key=lambda entry: entry["distance"])
    for key, distance in (("one", 1), ("most", fast["distance"])):
        entry = next(e for e in root["contacts"] if e["distance"] == distance and e["backend"] == fast["backend"])
        put(f"sets/missed/{key}", f"{100 * entry['missed'] / entry['pairs']:.0f}", source,
            f"% of contacts that a test once per step misses, {distance:g} sums of radii per step")
    put("sets/missed/distance", f"{fast['distance']:g}", source, "greatest distance per step, sums of radii")


def naive_sets(put, machine, others):
    root = sets(machine)
    for scene in ("uniform", "far", "grazing"):
        entries = [e for e in root["exactness"] if e["scene"] == scene]
        most = max(entries, key=lambda entry: entry["missed"] + entry["extra"])
        put(f"naive/{scene}", f"{most['missed'] + most['extra']:,}", root["id"], f"naive: wrong pairs, {scene}")
        put(f"naive/{scene}/right", f"{most['right']:,}", root["id"], f"right pairs, {scene}")
        for entry in entries:
            times = entry["exact"]["median_ms"] / entry["naive"]["median_ms"]
            what = f"{entry['backend']}, {scene}, exact predicate over naive"
            said(machine, scene != "grazing" or entry["backend"] == "cpu" or times > 2,
                 "exactness is expensive among grazing pairs")
            put(f"naive/{scene}/times/{entry['backend']}", f"{times:.{1 if times > 2 else 2}f}", root["id"], f"time, {what}")
    gas = [entry for entry in root["exactness"] if entry["scene"] == "uniform"]
    said(machine, all(entry["missed"] + entry["extra"] <= 1e-4 * entry["right"] for entry in gas),
         "in a gas the naive comparison is hardly ever wrong")
    put("naive/n", f"{most['n']:,}", root["id"], "spheres of the naive comparison")


def percent(share):
    return f"{100 * share:.0f}" if share >= 0.1 or share == 0 else f"{100 * share:.2g}"


def in_words(metres):
    """A power of ten as mathematics."""
    mantissa, exponent = f"{metres:.0e}".split("e")
    return f"$10^{{{int(exponent)}}}$" if mantissa == "1" else f"{metres:,.0f}"


def catalogue(put, machine, others):
    where = recorded_stress([machine, *others])
    tests = stressed(where)
    source = where.source("stress.json")["id"]
    put("stress/where", " and ".join(places(where)) or "whose host and commit the record does not name", source,
        "the machine that ran the stress catalogue")
    passed = [verdict for test in tests for verdict in test.verdicts.values() if verdict == "pass"]
    put("stress/rows", str(len({test.row for test in tests})), source, "rows of the stress catalogue")
    put("stress/passed", str(len(passed)), source, "tests of it, on all backends; none failed")
    sunk = next((figure for test in tests if "sinks" in test.what for figure in test.figures.values()), None)
    if sunk is None:
        raise Missing(f"{machine.name}: the catalogue does not say how deep the paper's method sinks")
    put("stress/sinks", re.match(r"[\d.]+", sunk)[0], source, f"m below the plane after 1000 s: {sunk}")


ACCURATE = (errors_of_motion, motion_at_scale, wrong_sets, naive_sets, catalogue)
