# SPDX-License-Identifier: MIT
"""What a record timed, and what of it has changed since: by the digests of kernels and host paths in its context.

The digests of the tree come from bench/io/source_digests.cmake, which the build uses as well. A name is glsl/KERNEL,
cuda/KERNEL, host/FOLDER, host/contacts or measure, the code that takes the samples.
"""
import json
import re
import shutil
import subprocess
import tempfile
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path

from paper import ids

ROOT = Path(__file__).resolve().parent.parent
MOST_NAMED = 4  # under a figure
OF_CONTACTS = "contact_|leapfrog|collide_swept"  # stages that host/contacts launches
SAID_OF_CONTACTS = {"sums", "sphere_steps_per_second", "sleeping"}  # only timings of contacts have one of these


class Unknown(Exception):
    """The digests of the tree cannot be made; the text says why."""


@lru_cache(maxsize=None)
def current(root=ROOT):
    """name -> digest, of the source tree as it is now."""
    if not shutil.which("cmake"):
        raise Unknown("whether records are stale is told by cmake, which is not installed (package cmake)")
    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder, "digests.json")
        script = ROOT / "bench/io/source_digests.cmake"
        made = subprocess.run(["cmake", f"-DSOURCE={root}", f"-DOUTPUT={output}", "-P", script], capture_output=True,
                              text=True)
        if made.returncode:
            raise Unknown(f"cmake cannot make the digests of {root}:\n{made.stderr.strip()}")
        return json.loads(output.read_text())


file_of = lru_cache(maxsize=None)(Path)  # of a recorded name: few, each asked for many thousand times


@lru_cache(maxsize=None)
def of_stage(name, stage):
    """Whether a stage runs this kernel, or one of its variants: draw_cull_far, mesh_indexed."""
    return bool(re.match(rf"{re.escape(file_of(name).stem)}(_|$)", stage))


def names_of(row, recorded):
    """What a timing depends on, of the recorded names; without a device timer it may be any kernel of its API, of contacts
    only where these are what is timed. Machine code and hardware counters depend on one kernel alone."""
    backend, stages = row.get("backend"), row.get("stages") or ()
    folder = ids.KERNELS.get(backend)
    kernels = {name for name in recorded if name.startswith(f"{folder}/") and
               any(of_stage(name, stage) for stage in stages)}
    if folder and not kernels:
        pushes = SAID_OF_CONTACTS & row.keys() or "option" in row
        kernels = {name for name in recorded if name.startswith(f"{folder}/") and
                   (pushes or not re.match(OF_CONTACTS, file_of(name).name))}
    if "kernel" in row:
        return kernels
    drawn = {name for name in recorded if file_of(name).suffix and of_stage(name, row.get("draw") or "")}
    contacts = {"host/contacts"} if SAID_OF_CONTACTS & row.keys() or any(re.match(OF_CONTACTS, stage) for stage in stages) else set()
    return kernels | drawn | (contacts | {f"host/{ids.HOSTS.get(backend)}", "measure"}) & recorded.keys()


def timings(value, above=None):
    """Every timing, listing or profile of a record, wherever it stands: its backend, way of drawing and stages."""
    if isinstance(value, list):
        for inner in value:
            yield from timings(inner, above)
    if not isinstance(value, dict):
        return
    row = {**(above or {}), **{key: value[key] for key in ("backend", "draw", "option", *SAID_OF_CONTACTS) if key in value}}
    if "samples_ms" in value:
        yield {**row, "stages": value.get("device_stages_ms")}
    if {"kernel", "backend"} <= value.keys():  # of listings and counters
        yield {"backend": value["backend"], "kernel": value["kernel"], "stages": [value["kernel"]]}
    if "compile_ms" in value:
        yield {"backend": value["name"], "stages": value["compile_ms"]}
    for inner in value.values():
        yield from timings(inner, row)


def changed(row, recorded, now):
    """The names that a timing depends on and whose digests are others now."""
    return {name for name in names_of(row, recorded) if now.get(name) != recorded[name]}


def parts(names):
    """E.g. collide_grid (GLSL, CUDA); host code (CUDA); host code of contacts; timing."""
    by_kernel = {"host code of contacts": []} if "host/contacts" in names else {}
    for name in sorted(names - {"host/contacts"}):
        room, _, kernel = name.rpartition("/")
        api, what = (kernel, "host code") if room == "host" else (room, Path(kernel).stem)
        apis = by_kernel.setdefault(what if api else "timing", [])
        named = api.capitalize() if api == "vulkan" else api.upper()
        apis += [named] if api and named not in apis else []
    return [f"{what} ({', '.join(sorted(apis, reverse=True))})" if apis else what for what, apis in by_kernel.items()]


def few(found):
    """The first of them as text, and how many more there are."""
    more = len(found) - MOST_NAMED
    return ", ".join(found[:MOST_NAMED]) + (f" and {more} more" if more > 0 else "")


def distinct(rows):
    """Rows that say the same of what they depend on, once: those of one record often share all of it."""
    return list({(row.get("backend"), row.get("draw"), frozenset(row.get("stages") or ()), frozenset(row.keys()), id(recorded)):
                 (row, recorded) for row, recorded in rows}.values())


def note(rows):
    """What the line under a figure or table of these timings adds: (row, digests of its record or None without) each."""
    rows = distinct(rows)
    found = parts(set().union(*(changed(row, recorded, current()) for row, recorded in rows if recorded)))
    notes = [f"recorded with earlier {few(found)}"] if found else []
    if any(recorded is None for _, recorded in rows):
        notes.append("recorded without digests of its kernels")
    return "; ".join(notes)


@dataclass
class Checked:
    """The timings of one file of a folder, or of all files below one of its folders."""
    timings: int = 0
    stale: int = 0
    changed: set = field(default_factory=set)
    without_digests: bool = False


def checked(folder, root=ROOT):
    """name -> Checked, of everything with times in a folder of records."""
    found = {}
    for path in sorted(Path(folder).rglob("*.json")):
        name = path.relative_to(folder).parts[0]
        record = json.loads(ids.today(path.read_text()))
        rows = list(timings(record)) if isinstance(record, dict) else []
        if not rows or name.startswith("."):  # a part that is being recorded
            continue
        recorded, entry = record.get("context", {}).get("sources"), found.setdefault(name, Checked())
        names = [changed(row, recorded, current(root)) for row in rows] if recorded else []
        entry.timings += len(rows)
        entry.stale += sum(map(bool, names)) if recorded else len(rows)
        entry.changed.update(*names)
        entry.without_digests |= not recorded
    return found
