# SPDX-License-Identifier: MIT
"""All tables of the paper, made from recorded runs alone and written as LaTeX and as text."""
import re

from paper.numbers.derived import driver_record
from paper.numbers.ratios import LEGEND, texts
from paper.records import Missing, original_paper, recorded_code
from paper.tables.apis import apis, opening
from paper.tables.claims import claims
from paper.tables.contacts import contacts
from paper.tables.counters import counters
from paper.tables.energy import energy
from paper.tables.extensions import extensions
from paper.tables.stress import stress
from paper.tables.studies import STUDIED
from paper.tables.suite import suite
from paper.tables.tabular import Table, as_tex, as_text, without_empty_columns
from paper.tables.variation import variation
from paper.text import APIS, cached, interval, ms


def median_or_dash(machine, **wanted):
    found = machine.select(**wanted)
    return ms(found[0].median) if found else "-"


TIMES_OF_TABLE1 = [("motion + plane", 3), ("pairs, CPU", 2), ("pairs, tile", 2), ("pairs, triangle", 2)]
NAMES_OF_TABLE1 = ["CPU", "OpenGL", "CUDA", "1 thread", "all", *["OpenGL", "CUDA"] * 2]


def sizes_of_table1(machine):
    return [record.n for record in machine.need(table="table1", backend="cpu", work="move")]


def records_of_table1(machine, n):
    """Those of one row, in the order of its columns; None for one that a machine lacks."""
    wanted = [{"work": "move", "backend": name} for name in ("cpu", "opengl", "cuda")]
    wanted += [{"method": method} for method in ("sequential", "parallel")]
    wanted += [{"method": method, "backend": name} for method in ("collide_tiled", "collide_triangle")
               for name in ("opengl", "cuda")]
    return [next(iter(machine.select(table="table1", n=n, **one)), None) for one in wanted]


def table1(machine):
    printed = {row[0]: row for row in original_paper()["table1"]}
    printed[32768] = [32768, None, None, None, None, None, original_paper()["text"]["largest n ms"]]
    rows = []
    for n in sizes_of_table1(machine):
        seed = printed.get(n, [None] * 7)
        shown = ["-" if seed[k] is None else f"{seed[k]:g}" for k in (4, 5, 6)]
        found = records_of_table1(machine, n)
        on_gpu = [record for record in found if record and record.backend != "cpu"]
        rows.append([cached(f"{n:,}", on_gpu), *shown, *(ms(record and record.median) for record in found)])
    heads = [[("", 1), ("original paper", 3), *TIMES_OF_TABLE1], ["n", "plane", "1 thread", "GLSL", *NAMES_OF_TABLE1]]
    return Table("table1", "The original paper's Table 1 (GeForce GTX 590, as printed; 32,768 from its text) and "
                 "ours: medians in milliseconds. Its 0 is below the resolution of its clock, its 16 one tick of it or one refresh. "
                 "†: all working sets fit in the L2 cache of the GPU.", heads, rows, left=0)


def table1_p95(machine):
    rows = [[f"{n:,}", *(ms(record and record.p95_ms) for record in records_of_table1(machine, n))]
            for n in sizes_of_table1(machine)]
    return Table("table1-p95", "The 95th percentiles of all rounds of our times in the original paper's Table 1, in "
                 "milliseconds.", [[("", 1), *TIMES_OF_TABLE1], ["n", *NAMES_OF_TABLE1]],
                 rows, left=0)


def frame_rates(machine):
    printed = {row[0]: row for row in original_paper()["table1"]}
    frames = {name: machine.need(table="frame_rates", work="frame", label=f"{name} frame")
              for name in ("sequential", "opengl", "cuda") if name == "sequential" or machine.has(name)}
    rows = []
    for n in [record.n for record in frames["sequential"]]:
        seed = printed.get(n, [None] * 7)
        rates = [f"{1e3 / record.median:,.0f}" if record.median < 100 else f"{1e3 / record.median:.1f}"
                 for records in frames.values() for record in records if record.n == n]
        drawn = [median_or_dash(machine, table="frame_rates", work="draw", n=n, label=f"{name} {method}")
                 for name in frames for method in (("mesh_each", "quadric") if name == "sequential" else ("mesh",))]
        rows.append([f"{n:,}", "-" if seed[1] is None else str(seed[1]), *rates,
                     *("-" if seed[k] is None else str(seed[k]) for k in (2, 3)), *drawn])
    names = [APIS[name] for name in list(frames)[1:]]
    heads = [[("", 1), ("frames per second", 2 + len(names)), ("drawing, ms: original", 2), ("1 thread", 2),
              ("one instanced draw", len(names))],
             ["n", "original", "1 thread", *names, "1 thread", "GLSL", "mesh", "GLUT's", *names]]
    source = frames["sequential"][0].source
    return Table("frame-rates", "The rest of the original paper's Table 1: frames per second of motion, pairs (its own "
                 "tile) and drawing, and drawing alone, in milliseconds. Its 60 frames per second are its display's.",
                 heads, rows, left=0, source=source)


def arrangements(machine):
    records = machine.need(table="arrangements")
    shapes = dict.fromkeys((r.scene["groups"], r.scene["group_size"]) for r in sorted(records, key=lambda r: r.n))
    names = [name for name in ("opengl", "cuda") if machine.has(name)]
    rows = []
    for m, n in shapes:
        of_shape = {(r.backend, r.block): r for r in records if (r.scene["groups"], r.scene["group_size"]) == (m, n)}
        rows.append([f"{m} by {n}", *(interval(of_shape[name, block], 1e3) if (name, block) in of_shape else "-"
                                           for block in (n, m * n) for name in names)])
    heads = [[("", 1), ("groups of $n$, µs", len(names)), ("one group of all, µs", len(names))],
             ["$m$ by $n$", *(APIS[name] for name in names), *(APIS[name] for name in names)]]
    return Table("arrangements", "The original paper's second animation: $m$ groups of $n$ spheres, searched by its own "
                 "tile in groups of exactly $n$ threads, and in one group of all.", heads, rows,
                 source=records[0].source)


def counts(machine):
    rows = []
    for scene, n, start, span, steps, sequential, parallel, _ in machine.main["tables"]["counts"][0]["rows"]:
        if scene == "random":
            rows.append([f"{int(n):,}", *(re.sub(r"\d{5,}", lambda long: f"{int(long[0]):,}", cell)
                                          for cell in (start, span, steps, sequential, parallel))])
    heads = [[("", 1), ("ours", 3), ("original paper", 2)],
             ["n", "first frame", "range", "steps", "sequential", "parallel"]]
    return Table("counts", "Colliding spheres in a box of 20 by 20 by 20 with radius 0.5, ours and the original "
                 "paper's ranges: evidence that the scene is the same.", heads, rows, left=0)


def methods(machine):
    pairs = {method: [machine.one(table="methods", method=f"collide_{method}", backend=name, block=128) for name in ("opengl", "cuda")]
             for method in ("group", "tiled", "square", "triangle")}
    rows = [[method, interval(glsl, 1e3), interval(cuda, 1e3), text]
            for (method, (glsl, cuda)), text in zip(pairs.items(), texts(list(pairs.values())))]
    heads = [[("", 1), ("median [interval], µs", 2), ("", 1)], ["method", "OpenGL", "CUDA", "OpenGL/CUDA"]]
    n = pairs["triangle"][0].n
    return Table("methods", f"One collision step of {n:,} spheres, groups of 128: medians, and the time ratio. {LEGEND}", heads, rows)


def peak_rates(machine):
    rows = []
    for record in machine.need(table="peak_rates"):
        rate = record.amount_per_step / (1e-3 * record.median)
        rows.append([record.work, f"{record.n:,}", APIS[record.backend], interval(record, 1e3),
                     f"{ms(rate)} {record.unit}"])
    heads = [[("", 1)] * 5, ["what", "spheres", "API", "median [interval], µs", "rate"]]
    return Table("peak-rates", "Peak rates of the GPU through each API: 16 bytes copied, a scattered atomic without a result, "
                 "and chains of multiply-adds, each per sphere.", heads, rows, left=1)


def code(machine):
    record, rows, (run, driver) = recorded_code(), [], driver_record(machine)
    for twin in record["twins"]:
        rows.append([twin["kernel"], *(str(twin[f"{what}_lines"]) for what in ("glsl", "cuda", "same")),
                     f"{twin['nvcc_seconds']:.1f}" if "nvcc_seconds" in twin else "-",
                     ms(driver.get(twin["kernel"]))])
    for what, name in (("support", "included by kernels"), ("host", "host code")):
        rows.append([name, str(record[what]["opengl"]), str(record[what]["cuda"]), "-", "-", "-"])
    rows.append(["host code of Vulkan", str(record["host"]["vulkan"]), "-", "-", "-", "-"])
    heads = [[("", 1), ("lines of code", 3), ("compiling", 2)],
             ["kernel", "GLSL", "CUDA", "same", "nvcc, s", "GLSL, ms"]]
    return Table("code", "Code and compile time of each API. Lines without blanks and comments; same: lines in both. nvcc: "
                 f"processor seconds on {record['context']['cpu']}, once, when the program is built." +
                 (" GLSL: the driver, in each program that uses it (-: a kernel that it does not have)." if driver else ""), heads, rows,
                 source=", ".join(filter(None, (record["id"], run))))


def machine_and_run(machine):
    context, glsl = machine.main["context"], machine.backend("opengl")["details"]
    build, host = context["build"], context["machine"]
    rows = [["run", machine.id], ["date", context["date"]], ["commit", build["commit"][:12]]]
    if machine.has("cuda"):
        rows += [["GPU", machine.backend("cuda")["device"]], ["driver", machine.driver],
                 ["CUDA", build["cuda_compiler"].split(",")[0]],
                 ["SM clock during the run", machine.seen("clocks.sm")],
                 ["throttle reasons seen", machine.seen("clocks_throttle_reasons.active")]]
    rows += [["GL", glsl["GL_VERSION"]], ["GL renderer", glsl["GL_RENDERER"]], ["CPU", host["cpu"].replace("(R)", "")],
             ["hardware threads", str(host["hardware_threads"])], ["system", host["system"]],
             ["compiler", build["compiler"]], ["flags", build["flags"]], ["seed", str(machine.main["seed"])]]
    heads = [[("", 1), ("", 1)], ["what", "recorded"]]
    return Table("machine", "The recorded machine and run.", heads, rows, left=2)


MAKERS = (claims, apis, opening, table1, table1_p95, frame_rates, arrangements, counts, methods, peak_rates, code, machine_and_run, stress, suite, counters,
          variation, energy, contacts, extensions, *STUDIED)


def of_one(maker, machine):
    machine.used.clear()
    table = without_empty_columns(maker(machine))
    machine.runs[table.name] = table.source.split(", ") if table.source else [machine.id]
    machine.note_on(table.name, table.source)
    return table


def made(machine):
    """Each table, or its name and the reason why it cannot be made."""
    for maker in MAKERS:
        try:
            yield of_one(maker, machine), None
        except Missing as reason:
            yield None, (maker.__name__, str(reason))


def table_title(table, machine):
    return "; ".join(text for text in (machine.title_of(machine.runs[table.name]), machine.notes.get(table.name)) if text)


def write(table, machine, folder):
    (folder / f"{table.name}.tex").write_text(as_tex(table))
    (folder / f"{table.name}.txt").write_text(as_text(table, table_title(table, machine)))


def write_all(machine, folder):
    """Returns (the tables that were written, what was left out and why)."""
    written, left_out = [], []
    folder.mkdir(parents=True, exist_ok=True)
    for table, reason in made(machine):
        if reason:
            left_out.append(reason)
            (folder / f"{reason[0].replace('_', '-')}.tex").unlink(missing_ok=True)  # of an earlier run
            continue
        write(table, machine, folder)
        written.append(table)
    return written, left_out
