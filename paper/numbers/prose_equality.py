# SPDX-License-Identifier: MIT
"""Numbers of the prose about equality (comparisons, tests, common configurations of two machines) and about the code."""
import json
import re
import statistics

from paper.numbers.contests import contests
from paper.numbers.derived import driver_milliseconds
from paper.numbers.ratios import ENOUGH
from paper.numbers.suite import suite
from paper.records import Missing, recorded_code, said

AIM = 0.5  # %, of the longest batch, for which the program chooses K


def comparisons(put, machine, others):
    if machine.main["verdict"] not in ("equal", "unfinished"):  # everything in a truncated file was found equal
        raise Missing(f"{machine.name}: the run ended with the verdict {machine.main['verdict']}")
    compared = sum((len(entry["configurations"]) - 1) * len(entry["checkpoints"]) for entry in machine.main["equality"])
    said(machine, all(entry["verdict"] == "equal" for entry in machine.main["equality"]), "all results are equal")
    put("equal/results", f"{compared:,}", machine.id, "results compared with a reference, all equal")
    scenes = {json.dumps(entry["scene"]) for entry in machine.main["equality"]}
    put("equal/scenes", f"{len(scenes):,}", machine.id, "scenes, sizes and radii among them")


def checkpoints(machine):
    """Configuration -> result, as `spherepair equal` compares two machines."""
    return {json.dumps([entry["scene"], entry["set"], point["step"]]): json.dumps(point)
            for entry in machine.main["equality"] for point in entry["checkpoints"]}


def across_machines(put, machine, others):
    ours = checkpoints(machine)
    for other in others:
        theirs = checkpoints(other)
        common = ours.keys() & theirs.keys()
        if any(ours[key] != theirs[key] for key in common):
            raise Missing(f"{machine.name} and {other.name} differ, which contradicts the text")
        put(f"equal/common/{other.name}", f"{len(common):,}", f"{machine.id}, {other.id}",
            "common configurations: equal pairs, counts, fingerprints and state hashes")


def long_run(put, machine, others):
    record = machine.source("state_hashes.json")
    hashes = {tuple(run["hashes"]) for found in (machine, *others) for run in found.source("state_hashes.json")["runs"]}
    if len(hashes) != 1:
        raise Missing("the recorded long runs differ, which contradicts the text")
    steps = record["every"] * len(record["runs"][0]["hashes"])
    put("long/spheres", f"{record['n']:,}", record["id"], "spheres of the long run")
    put("long/steps", f"{steps:,}", record["id"], "steps of the long run")
    put("long/every", f"{record['every']:,}", record["id"], "steps between two hashes")
    runs = sum(len(found.source("state_hashes.json")["runs"]) for found in (machine, *others))
    put("long/runs", str(runs), ", ".join(found.source("state_hashes.json")["id"] for found in (machine, *others)),
        "runs with the same hashes")


def tests(put, machine, others):
    found = suite(machine)
    pairs, ties = found.decided("cuda")
    put("tests/passed", f"{sum(verdict == 'OK' for verdict in found.verdicts.values()):,}", found.source,
        "tests passed, each name once; none failed")
    put("tests/pairs", f"{pairs:,}", found.source, "adversarial pairs that each backend decided, none wrong")
    put("tests/ties", f"{ties:,}", found.source, "exact ties among them")


def code(put, machine, others):
    record = recorded_code()
    for name, language in (("opengl", "glsl"), ("cuda", "cuda")):
        lines = sum(twin[f"{language}_lines"] for twin in record["twins"])
        put(f"code/kernels/{name}", f"{lines:,}", record["id"], f"lines of all kernels in {name}")
        put(f"code/host/{name}", f"{record['host'][name]:,}", record["id"], f"lines of host code of {name} alone")
    put("code/host/vulkan", f"{record['host']['vulkan']:,}", record["id"], "lines of host code of vulkan alone")
    put("code/same", f"{sum(twin['same_lines'] for twin in record['twins']):,}", record["id"], "lines common to both")
    seconds = [twin["nvcc_seconds"] for twin in record["twins"] if "nvcc_seconds" in twin]
    if len(seconds) != len(record["twins"]):
        raise Missing("not every kernel was compiled when the code was counted")
    put("code/nvcc", f"{sum(seconds):.0f}", record["id"], "processor seconds of nvcc for all kernels")


def drivers_compiler(put, machine, others):
    driver = driver_milliseconds(machine)
    if not driver:
        raise Missing(f"{machine.name} has no record of `spherepair devices --compile`")
    source = next(root["id"] for root in machine.sources.values() if "backends" in root and
                  any(isinstance(entry, dict) and entry.get("compile_ms") for entry in root["backends"]))
    slowest = max(driver, key=driver.get)
    put("compile/kernels", str(len(driver)), source, "kernels whose compilation by the GL driver was timed")
    put("compile/all", f"{1e-3 * sum(driver.values()):.1f}", source, "s, the GL driver's compilation of all kernels")
    put("compile/most", f"{1e-3 * driver[slowest]:.1f}", source, f"s, of the slowest, {slowest}")
    put("compile/most/kernel", slowest, source, "the slowest to compile")


def on_the_cpu(record):
    """A gas with contacts, whose steps take too long for as many rounds."""
    return record.parameters.get("table") == "gas_steps" and record.backend == "cpu"


def provenance(put, machine, others):
    """Of how many commits and GPUs the records are, and how many intervals cover less than 95 %."""
    roots = [root for root in machine.sources.values() if "context" in root]
    processes = [process for root in roots for process in root.get("processes", ())]
    commits = {root["context"]["build"]["commit"] for root in roots} | {process["commit"] for process in processes}
    gpus = {backend["uuid"] for root in roots for backend in root.get("backends", [])
            if isinstance(backend, dict) and backend.get("uuid")}
    gpus |= {gpu for process in processes for gpu in process["gpus"] if re.fullmatch(r"[0-9a-f]{32}", gpu.replace("-", ""))}
    put("records/commits", str(len(commits)), machine.id, "commits of the program among the records")
    put("records/gpus", str(len(gpus)), machine.id, "GPUs of one model among the records, by UUID")
    timed = [rounds for record in machine.records if "samples_ms" in record.parameters and not on_the_cpu(record)
             for rounds in [process["rounds"] for process in record.parameters.get("processes", ())] or [len(record.samples_ms)]]
    few = [rounds for rounds in timed if rounds < ENOUGH]
    put("records/rounds", " or ".join(map(str, sorted(set(timed) - set(few)))), machine.id, "rounds of a timing in a process")
    said(machine, all(entry.same_steps for entry in contests(machine)), "both APIs of a contest have as many steps a sample")
    put("records/few", str(len(few)), machine.id, f"times of fewer than {ENOUGH} rounds, whose intervals cover less than 95 %")
    put("records/least", str(min(timed)), machine.id, "fewest rounds of a time")
    put("records/least/cover", f"{100 * (1 - 2 * 0.5**min(timed)):.0f}", machine.id, "%, what the interval of the fewest rounds covers")


def fixed_costs(put, machine, others):
    """What a batch costs besides its steps, as the fit of the slope tells it: its magnitude over the longest batch."""
    shares = {}
    for record in machine.records:
        if record.parameters.get("fixed_cost_share") is not None:
            shares.setdefault(record.backend, []).append(100 * abs(record.fixed_cost_share))
    together = sum(shares.values(), [])
    put("fixed/timings", f"{len(together):,}", machine.id, "timings whose fixed cost a fit tells, those of several processes once")
    put("fixed/most", f"{max(together):.0f}", machine.id, "%, greatest magnitude of the fixed cost over the longest batch")
    put("fixed/under", f"{share_under(together):.0f}", machine.id, f"%, timings with less than {AIM} % of it")
    for name, found in shares.items():
        put(f"fixed/{name}", f"{statistics.median(found):.1f}", machine.id, f"%, median of it, {name}")
        put(f"fixed/under/{name}", f"{share_under(found):.0f}", machine.id, f"%, timings with less than {AIM} %, {name}")


def share_under(shares):
    return 100 * sum(share < AIM for share in shares) / len(shares)


EQUALITY = (comparisons, across_machines, long_run, tests, code, drivers_compiler, provenance, fixed_costs)
