# SPDX-License-Identifier: MIT
"""Numbers of the prose about contacts: what sums in integers keep, errors by time step, and times."""
import re

from paper import ids
from paper.numbers.derived import matched, over_other_sums
from paper.numbers.prose_accuracy import in_words, scientific
from paper.numbers.ratios import family, time_ratio
from paper.records import Missing, digest, said

KINDS = {("spring", 1): "spring", ("spring", 0.9): "damped", ("hertz", 1): "hertz", ("quartic", 1): "quartic"}
LARGE = 10**6  # spheres from which a step is no matter of launches


def by_sums(machine):
    found = {}
    for row in machine.need(table="contact_runs"):
        found.setdefault(row.sums, []).append(row)
    return found


def elastic(rows):
    return [row for row in rows if row.restitution == 1]


def contact_bits(put, machine, others):
    found = by_sums(machine)
    integers, in_order, atomics = (found[sums] for sums in ("integers", "in_order", "atomics"))
    source, settings = integers[0].source, machine.source("contacts.json")["settings"]
    said(machine, all(not any(row.momentum) for row in integers) and all(row.returns for row in elastic(integers)),
         "with integer sums every run keeps its momentum, and every elastic one goes back to its first bits")
    said(machine, all(row.returns for row in elastic(in_order)) and all(any(row.momentum) for row in in_order),
         "float32 sums in a fixed order go back, too, but do not keep the momentum")
    lost = [row for row in elastic(atomics) if not row.returns]
    said(machine, len(lost) > 0.5 * len(elastic(atomics)), "with float32 atomics most runs do not go back")
    put("contacts/n", f"{integers[0].n:,}", source, "spheres of the runs with contacts")
    put("contacts/collisions", f"{settings['collisions']:g}", source, "mean times between collisions that a run takes")
    put("contacts/runs", str(len(integers)), source, "runs with integer sums, all of which keep the momentum")
    put("contacts/elastic", str(len(elastic(integers))), source, "elastic runs among them, all of which go back")
    put("contacts/lost", f"{len(lost)} of {len(elastic(atomics))}", source, "elastic runs with atomics that do not go back")
    put("contacts/momentum", f"{max(abs(change) for row in in_order for change in row.momentum):,}", source,
        "units of the state's integers, greatest change of the momentum with float32 sums in a fixed order")


def long_contacts(put, machine, others):
    """The energy after the longest run, from what its test printed."""
    path = machine.folder / "tests/contacts_long.txt"
    if not path.exists():
        raise Missing(f"{machine.name} has no contacts_long.txt")
    text = ids.today(path.read_text())
    found = dict(re.findall(r"^(opengl|cuda): energy changed by (\S+ of it in \d+) steps", text, re.MULTILINE))
    said(machine, len(found) == 2 and len(set(found.values())) == 1, "the long run of contacts has the same energy in both APIs")
    change, steps = re.match(r"(\S+) of it in (\d+)", found["cuda"]).groups()
    put("contacts/long/steps", f"{int(steps):,}", f"{machine.name}:{digest(text.encode())}", "steps of the longest run with contacts")
    put("contacts/long/energy", scientific(abs(float(change))), f"{machine.name}:{digest(text.encode())}",
        "change of the energy over it")


def contact_errors(put, machine, others):
    found = by_sums(machine)
    right = {(row.law, row.restitution, row.steps_a_contact, row.backend): row for row in found["integers"]}
    said(machine, all(abs(row.position / right[row.law, row.restitution, row.steps_a_contact, row.backend].position - 1) < 0.01
                      for rows in found.values() for row in rows), "errors of contacts are the same, whatever the sums")
    steps = sorted({row.steps_a_contact for row in found["integers"]})
    for key, count in (("coarsest", steps[0]), ("finest", steps[-1])):
        put(f"contacts/{key}", str(count), found["integers"][0].source, f"steps a contact, {key}")
        for row in found["integers"]:
            if row.backend == "cuda" and row.steps_a_contact == count:
                kind = KINDS[row.law, round(row.restitution, 3)]
                put(f"contacts/error/{kind}/{key}", scientific(row.position), row.source, f"rms error in radii, {kind}, {count} steps a contact")


def contact_rates(put, machine, others):
    """Of a gas: its pressure and cooling, against the finest step and against kinetic theory."""
    root = machine.sources.get("contacts_errors.json") or machine.source("contacts.json")
    steps = {row["steps_a_contact"] for row in root["contact_rates"]}
    put("rates/converged", str(max(steps)), root["id"], "steps a contact of the runs that others are compared with")
    put("rates/n", f"{root['settings']['rates']['n']:,}", root["id"], "spheres of a gas whose rates are measured")
    put("rates/gases", str(root["settings"]["rates"]["seeds"]), root["id"], "such gases, of which errors are medians")
    compared = [row["error"] for row in root["contact_rates"] if row["error"]]
    put("rates/errors", str(len(compared)), root["id"], "errors of rates, by quantity and time step")
    put("rates/zero", str(sum(error["low"] <= 0 <= error["high"] for error in compared)), root["id"], "those whose interval holds 0")
    for quantity in ("pressure", "cooling time"):
        rows, key = [row for row in root["contact_rates"] if row["quantity"] == quantity], quantity.split()[0]
        worst = max(abs(row["error"]["median"]) for row in rows if row["error"])
        said(machine, worst < 0.01, f"the time step changes the {quantity} by less than a percent")
        put(f"rates/{key}/error", f"{100 * worst:.1f}", root["id"], f"%, greatest median error of the {quantity} by time step")
        theory = [100 * (row["over_theory"]["median"] - 1) for row in rows]
        said(machine, quantity == "pressure" or min(theory) > 0, "a gas cools more slowly than by Haff's law")
        put(f"rates/{key}/theory", f"{min(theory):.1f} to {max(theory):.1f}" if min(theory) > 1 else f"{max(map(abs, theory)):.1f}",
            root["id"], f"%, the {quantity} against kinetic theory, of all time steps")


def contact_times(put, machine, others):
    pairs = matched(machine, table="gas_steps")
    sources = ", ".join(dict.fromkeys(cuda.source for _, cuda in pairs))
    fastest = max((cuda for _, cuda in pairs), key=lambda cuda: cuda.sphere_steps_per_second)
    put("contacts/rate", f"{fastest.sphere_steps_per_second / 1e10:.2f}", fastest.source, f"10^10 sphere-steps/s, CUDA, n = {fastest.n}")
    said(machine, all(cuda.sphere_steps_per_second > 1e10 for _, cuda in pairs), "CUDA does more than 10^10 sphere-steps/s")
    ratios = [f"{time_ratio(glsl, cuda).middle:.2f}x at {in_words(glsl.n)}" for glsl, cuda in pairs]
    put("contacts/ratios", f"{', '.join(ratios[:-1])} and {ratios[-1]}", sources, "time ratios GLSL/CUDA of whole steps with contacts")
    for sums in ("in_order", "atomics"):
        pairs = over_other_sums(machine, sums)
        ratios = dict(zip(pairs, family(list(pairs.values()))))
        found = [ratio.middle for (n, _), ratio in ratios.items() if n >= LARGE]
        said(machine, not any(ratio.decided and ratio.middle > 1 for ratio in ratios.values()) and max(found) < 1,
             f"no cost of integer sums against {sums} is seen, and in large gases they take less time")
        put(f"contacts/{sums}", f"{min(found):.2f}x to {max(found):.2f}x", machine.source("contacts.json")["id"],
            f"time of a step with integer sums over that with float32 sums, {sums}, from {LARGE} spheres on")


def contact_rest(put, machine, others):
    """Of a bed at rest: the time of a step of which all spheres take part over that of one that passes over them."""
    for record, name in (("contacts_rest", "rest"), ("contacts_rest_1e7", "rest/large")):
        root = machine.source(f"{record}.json")
        (bed,) = root["beds"]
        said(machine, bed["unmoved"] == 1 and bed["kinetic"] < 1e-12 and abs(bed["floor_force"] - 1) < 1e-6,
             "a bed comes to rest to the bit, and the floor carries its weight")
        put(f"{name}/n", f"{bed['n']:,}", root["id"], "spheres of a bed at rest")
        put(f"{name}/layers", str(root["settings"]["rest"]["layers"]), root["id"], "its layers")
        put(f"{name}/overlap", f"{100 * bed['overlap']:.1f}", root["id"], "% of a radius, the greatest overlap in it")
        for row in bed["steps"]:
            if row["sleeping"]:
                put(f"{name}/{row['backend']}", f"{row['awake_over_this']['ratio']:.1f}x", root["id"],
                    f"{row['backend']}: time of a step of all spheres over that of one that passes over spheres at rest")


CONTACTS = (contact_bits, long_contacts, contact_errors, contact_rates, contact_times, contact_rest)
