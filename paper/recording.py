# SPDX-License-Identifier: MIT
"""Runs the parts of a recording, each in a folder of its own that becomes part of the machine's only when it is whole."""
import fcntl
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from contextlib import contextmanager
from pathlib import Path

from paper import parts, sources
from paper.tools import Failed

ROOT = Path(__file__).resolve().parent.parent
LINES_OF_A_FAILURE = 12


def devices_of(program):
    """The record of `spherepair devices`."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "devices.json")
        try:
            made = subprocess.run([program, "devices", "--json", file], capture_output=True, text=True)
        except OSError as reason:
            raise Failed(f"{program} cannot be run ({reason.strerror}): ./reproduce builds it; --program names another")
        if made.returncode or not file.exists():
            raise Failed(f"`{program} devices` failed with exit code {made.returncode}:\n{made.stderr.strip()}")
        return json.loads(file.read_text())


def check_program(program, record):
    """A program of other sources would leave records that are stale from the start."""
    recorded = record["context"].get("sources")
    if recorded is None:
        raise Failed(f"{program} is of a version without digests of its sources: build it again")
    try:
        now = sources.current()
    except sources.Unknown as reason:
        print(f"warning: whether {program} is of these sources is not checked: {reason}", file=sys.stderr)
        return
    other = sources.parts({name for name in now.keys() | recorded.keys() if now.get(name) != recorded.get(name)})
    if other:
        raise Failed(f"{program} was built from other sources than these, {', '.join(other)}: build it again")
    commit = record["context"]["build"]["commit"]
    if commit.endswith("-dirty"):
        print(f"warning: {program} was built with local changes; its records name the commit {commit}", file=sys.stderr)


def older_records(folder, planned):
    """Records of the same parts from before their processes were numbered."""
    numbered = {run.part.name for run in planned if parts.numbered(run.part)}
    files = {f"{name}.json" for name in numbered} | {"stress.json"}
    found = [path for path in sorted(folder.glob("*.json")) if path.name in files]
    return found + [folder / name for name in sorted(numbered) if any((folder / name).glob("[!0-9]*.json"))]


class Progress:
    """The part, the time it takes and a line when it is done; on a terminal the time passes."""

    def __init__(self, heading):
        self.heading, self.start, self.terminal = heading, time.monotonic(), sys.stdout.isatty()
        self.show()

    def minutes(self):
        return (time.monotonic() - self.start) / 60

    def show(self):
        if self.terminal:
            print(f"\r\033[K{self.heading} ... {self.minutes():.1f} min", end="", flush=True)

    def end(self, outcome):
        print(("\r\033[K" if self.terminal else "") + f"{self.heading}: {outcome}", flush=True)


def run_command(words, environment, log, progress):
    """Its exit code; an interruption ends it as well."""
    try:
        process = subprocess.Popen(words, env={**os.environ, **environment}, stdout=log, stderr=subprocess.STDOUT,
                                   stdin=subprocess.DEVNULL)
    except OSError as reason:
        raise Failed(f"{words[0]} cannot be run ({reason.strerror}): ./check builds the program and the tests; "
                     "--program and --tests name others")
    try:
        while True:
            try:
                return process.wait(timeout=1)
            except subprocess.TimeoutExpired:
                progress.show()
    except BaseException:
        process.send_signal(signal.SIGTERM)
        process.wait()
        raise


@contextmanager
def host_of(part, progress):
    """The host, alone or with other parts that do not need it alone; waits for those that another process records."""
    wanted = fcntl.LOCK_EX if part.alone else fcntl.LOCK_SH
    with open(Path(tempfile.gettempdir(), f"spherepair-recording-{os.getuid()}"), "a") as lock:
        try:
            fcntl.flock(lock, wanted | fcntl.LOCK_NB)
        except BlockingIOError:
            progress.end("waits for another recording on this host")
            fcntl.flock(lock, wanted)
            progress.start = time.monotonic()
        yield


def defect_of(path):
    """Why an output is not a whole record, or nothing."""
    files = sorted(path.rglob("*.json")) if path.is_dir() else [path]
    if not files:
        return f"{path.name} holds no records"
    for file in files:
        if not file.exists():
            return f"{file.name} was not written"
        if file.suffix == ".txt" and not re.search(r"^commit: .+\ndate: .+$", file.read_text(errors="replace"), re.MULTILINE):
            return f"{file.name} names no commit and date: the tests are older than these sources, so build them again (./check)"
        if file.suffix != ".json":
            continue
        try:
            root = json.loads(file.read_text())
        except ValueError as reason:
            return f"{file.name} is not JSON ({reason})"
        if root.get("complete") is False or root.get("verdict") in ("unfinished", "difference"):
            return f"{file.name} is of a run that did not end or found a difference"
        if file.name == "stress.json" and "context" not in root:
            return f"{file.name} names no commit and machine: the tests are older than these sources, so build them again (./check)"
    return ""


def without_folders(text):
    """Of a record, without the folders of the machine: words of a command that are absolute paths become their last part."""
    return re.sub(r'([\[,]\s*)"/[^"]*/([^"/]+)"', r'\1"\2"', text).replace(f"{ROOT}/", "")


def runner(part, program, tests):
    """The words ahead of a part's own."""
    if part.script:
        return [ROOT / "paper" / part.script, "--program", program]
    return [tests if part.tests else program]


def record_run(run, folder, run_by, gpu, progress):
    """Runs one part; its output is in the folder whole, or not at all."""
    out = folder / f".{run.name}"
    shutil.rmtree(out, ignore_errors=True)  # of a run that was killed
    out.mkdir(parents=True)
    try:
        words, environment = run.command(out, gpu)
        log = out / "output.txt"
        with log.open("w") as stream:
            code = run_command([*run_by, *words], environment, stream, progress)
        reason = f"exit code {code}" if code else next(filter(None, (defect_of(out / file) for file in run.targets())), "")
        if reason:
            last = log.read_text(errors="replace").splitlines()[-LINES_OF_A_FAILURE:]
            command = " ".join([*(f"{name}={value}" for name, value in environment.items()), *map(str, run_by), *words])
            raise Failed("\n".join([f"{reason}; {command} ended with:", *(f"  {line}" for line in last)]))
        for file, target in run.targets().items():
            (folder / target).parent.mkdir(parents=True, exist_ok=True)
            shutil.rmtree(folder / target, ignore_errors=True)  # a sweep that is recorded again
            made = [out / file] if (out / file).is_file() else (out / file).rglob("*")
            for path in filter(Path.is_file, made):
                text = path.read_text(errors="surrogateescape")  # names of files in a test's output may be any bytes
                path.write_text(without_folders(text), errors="surrogateescape")
            (out / file).replace(folder / target)
    finally:
        shutil.rmtree(out, ignore_errors=True)


def record_all(chosen, folder, program, tests, gpu=""):
    """Runs them in order; those that fail are named at the end. Returns their number."""
    failures = []
    for k, run in enumerate(chosen, 1):
        progress = Progress(f"[{k}/{len(chosen)}] {run.name}, about {run.part.minutes} min")
        try:
            with host_of(run.part, progress):
                record_run(run, folder, runner(run.part, program, tests), gpu, progress)
            progress.end(f"{progress.minutes():.1f} min")
        except (Failed, OSError) as reason:
            failures.append(f"{run.name} failed, {reason}")
            progress.end("failed")
        except KeyboardInterrupt:
            progress.end("interrupted, nothing of it is kept")
            raise
    for failure in failures:
        print(f"record: {failure}", file=sys.stderr)
    return len(failures)


def state_of(part, planned, folder, backends):
    runs = [run for run in planned if run.part == part]
    done = [run for run in runs if parts.done(run, folder)]
    if len(done) == len(runs):
        return "done"
    reason = parts.missing_needs(part, backends) or "missing"
    return f"{reason}; done: {', '.join(run.name for run in done)}" if done else reason


def table_of(planned, folder, backends):
    """The lines of --list."""
    all_parts = list(dict.fromkeys(run.part.name for run in planned))
    width = max(map(len, all_parts))
    yield f"{'part':<{width}}  minutes  processes  {'needs':<21}  state"
    for name in all_parts:
        runs = [run for run in planned if run.part.name == name]
        part = runs[0].part
        needs = ",".join(part.backends) + (f" {part.memory // parts.GIB} GiB" if part.memory else "") + " alone" * part.alone
        yield f"{name:<{width}}  {part.minutes:7}  {len(runs):9}  {needs:<21}  {state_of(part, planned, folder, backends)}"
    left = [run for run in planned if not parts.done(run, folder) and not parts.missing_needs(run.part, backends)]
    minutes = sum(run.part.minutes for run in left)
    yield f"{len(left)} of {len(planned)} runs are missing, about {minutes} minutes (estimated)"
