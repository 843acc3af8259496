# SPDX-License-Identifier: MIT
"""The table of energy: what a step takes of it through each API, from `spherepair energy`."""
from paper.records import Missing
from paper.tables.tabular import Table
from paper.text import ms

DEVICES = ("opengl", "cuda")
MOST = 0.03  # that the two methods may be apart, as a share
WORKS = {"all_pairs": "all pairs", "warm": "grid, in cell order", "cold": "grid, in random order"}
CAPTION = ("Energy of a search: power of the whole GPU, energy of a step and of a sphere, OpenGL's energy over CUDA's. By NVML's "
           "energy counter over windows of {seconds:.0f} s of back-to-back steps, the power of the idle GPU, {idle} W, "
           "subtracted. The integrated power ({power}) gives energies that are at most {apart:.1f} \\% apart.")
LEFT_OUT = " Left out, since both methods differ by more than {most:.0f} \\%: {names}."


def cells_of(record):
    if record is None:
        return ["-"] * 3
    return [f"{record.counter_watts:.0f}", ms(1e3 * record.joules_per_step), ms(record.nanojoules_per_sphere)]


def energy(machine):
    rows, kept, apart = [], [], []
    for work, words in WORKS.items():
        for n in dict.fromkeys(record.n for record in machine.select(table="energy", work=work)):
            found = {}
            for record in machine.select(table="energy", work=work, n=n):
                agrees = abs(record.disagreement) <= MOST
                (kept if agrees else apart).append(record)
                if agrees:
                    found[record.backend] = record
            both = len(found) == len(DEVICES)
            ratio = f"{found['opengl'].joules_per_step / found['cuda'].joules_per_step:.2f}" if both else "-"
            if found:
                rows.append([words, f"{n:,}", *(cell for name in DEVICES for cell in cells_of(found.get(name))), ratio])
    if not rows:
        raise Missing(f"{machine.name} has no record of table energy whose two methods agree")
    idle = sorted({f"{record.idle_counter_watts:.0f}" for record in kept})
    caption = CAPTION.format(seconds=min(window["seconds"] for record in kept for window in record.windows),
                             idle=" to ".join(dict.fromkeys((idle[0], idle[-1]))), power=kept[0].power,
                             apart=100 * max(abs(record.disagreement) for record in kept))
    if apart:
        caption += LEFT_OUT.format(most=100 * MOST, names=", ".join(record.label.replace("_", " ") for record in apart))
    heads = [[("", 2), ("OpenGL", 3), ("CUDA", 3), ("", 1)], ["search", "spheres", *["W", "mJ", "nJ a sphere"] * 2, "ratio"]]
    return Table("energy", caption, heads, rows, left=1, source=", ".join(dict.fromkeys(r.source for r in kept)))
