# SPDX-License-Identifier: MIT
"""Stand-ins for the program, which leaves the records that said.json tells, and for NVIDIA's tools, which print what they
would of one small kernel with a loop of two pairs."""
import json
import os
import pathlib
import stat
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from paper import sources  # noqa: E402  (the path must be set first)

PROGRAM = '''#!{python}
import json, os, pathlib, sys, time
here = pathlib.Path(__file__).parent
said = json.loads((here / "said.json").read_text())
words = sys.argv[1:]
if words[0] == "devices" and not {{"--compile", "--first-use"}} & set(words):
    pathlib.Path(words[words.index("--json") + 1]).write_text(json.dumps(said["devices"]))
    sys.exit(0)
with (here / "calls.txt").open("a") as calls:
    print(os.getpid(), *words, file=calls)
with (here / "gpus.txt").open("a") as gpus:
    print(os.environ.get("CUDA_VISIBLE_DEVICES", "-"), file=gpus)
if said["sleeps"]:
    print("sleeping", flush=True)
    time.sleep(60)
if words[0] == said["fails"]:
    print("the GPU fell off the bus")
    sys.exit(3)
record = {{"context": {{**said["devices"]["context"], "command": sys.argv}}, "backends": said["devices"]["backends"], "clocks": [],
          "verdict": said["verdict"], "measurements": [{{"table": "step", "label": "made up", "backend": "cuda", "n": 64,
          "scene": {{"name": "random"}}, "samples_ms": [1, 2, 3], "device_stages_ms": {{"move": 1}}}}]}}
text = said["text"] or json.dumps(record)
if words[0].startswith("--gtest_filter"):
    out = pathlib.Path(os.environ["SPHEREPAIR_RECORD"])
    if not said["older_tests"]:
        print("commit: made-up\\ndate: 2026-01-01T00:00:00Z")
    context = {{}} if said["older_tests"] else {{"context": said["devices"]["context"]}}
    for name in ("stress.json", "state_hashes.json"):
        (out / name).write_text(json.dumps({{**context, "rows": [{{"row": words[0]}}]}}))
elif words[0] == "run":  # the driver keeps the code of its shaders
    pathlib.Path(os.environ["__GL_SHADER_DISK_CACHE_PATH"], "entry").write_bytes(
        b"NVuc".ljust(32) + b"\\1\\0\\0\\0\\x20\\0\\0\\0\\x40".ljust(32, b"\\0") + bytes(32))
elif words[0] == "devices":
    pathlib.Path(words[words.index("--json") + 1]).write_text(text)
else:
    folder = pathlib.Path(words[words.index("--results") + 1])
    folder.mkdir(parents=True, exist_ok=True)
    name = "grid-1.json" if words[0] == "sweep" else "results.json" if words[0] == "compare" else words[0] + ".json"
    (folder / name).write_text(text)
'''

LOOP = """
	.headerflags	@"EF_CUDA_SM90"
        /*0000*/                   LDC R1, c[0x0][0x28] ;                  /* 0x00000a00ff017b82 */
                                                                           /* 0x000fe20000000800 */
        /*0010*/                   LDS.128 R4, [R8] ;                      /* 0x0000000008047984 */
        /*0020*/                   FADD R12, R4, -R20 ;                    /* 0x8000001404147221 */
        /*0030*/                   FSETP.GT.AND P0, PT, R12, UR5, PT ;     /* 0x000000050c007c0b */
        /*0040*/                   FSETP.GT.AND P1, PT, R13, UR5, PT ;     /* 0x000000050d007c0b */
        /*0050*/               @P0 BRA 0x80 ;                              /* 0x0000000000080947 */
        /*0060*/                   FADD R13, R5, -R21 ;                    /* 0x8000001505157221 */
        /*0070*/                   RED.E.ADD desc[UR4][R2.64], R13 ;       /* 0x0000000d0200798e */
        /*0080*/              @!P2 BRA 0x10 ;                              /* 0xffffffffffe4a947 */
        /*0090*/                   EXIT ;                                  /* 0x000000000000794d */
        /*00a0*/                   BRA 0xa0;                               /* 0xfffffffffffc7947 */
"""
FUNCTION = "_ZN10spherepair{length}{kernel}ILi{block}ELb{equal}ELb{listed}EEEv6ParamsNS_13KernelBuffersE"
COUNTERS = {"gpu__time_duration.sum": "12,345", "smsp__issue_active.avg.pct_of_peak_sustained_active": "71.5",
            "smsp__inst_executed.sum": "5,000,000,000", "smsp__cycles_elapsed.avg.per_second": "1,700,000,000",
            "smsp__average_inst_executed_per_warp.ratio": "1,060", "launch__registers_per_thread": "40",
            "sm__warps_active.avg.pct_of_peak_sustained_active": "90", "dram__throughput.avg.pct_of_peak_sustained_elapsed": "30",
            "l1tex__throughput.avg.pct_of_peak_sustained_active": "85", "lts__throughput.avg.pct_of_peak_sustained_elapsed": "45",
            "l1tex__data_pipe_lsu_wavefronts.avg.pct_of_peak_sustained_elapsed": "82.5",
            "breakdown:sm__throughput.avg.pct_of_peak_sustained_elapsed": "",
            "smsp__average_warps_issue_stalled_long_scoreboard_per_issue_active.ratio": "4.5",
            "smsp__average_warps_issue_stalled_long_scoreboard_not_issued_per_issue_active.ratio": "9",
            "smsp__average_warps_issue_stalled_wait_per_issue_active.ratio": "1.5",
            "smsp__average_warps_issue_stalled_selected_per_issue_active.ratio": "1"}


def functions():
    """As cuobjdump tells their registers: every kernel in four variants of two group sizes."""
    for kernel in ("collide_tiled", "collide_triangle", "collide_grid"):
        for block in (64, 128):
            for equal in (0, 1):
                for listed in (0, 1):
                    name = FUNCTION.format(length=len(kernel), kernel=kernel, block=block, equal=equal, listed=listed)
                    yield f" Function {name}:\n  REG:{40 + equal + listed} STACK:0 SHARED:2048 LOCAL:0 CONSTANT[0]:700\n"


def report(counters=COUNTERS, kernels=("grid_bounds", "collide_grid", "collide_triangle")):
    """The raw page of Nsight Compute's report: three launches of each kernel, behind a line of units."""
    def line(*cells):
        return ",".join(f'"{cell}"' for cell in cells) + "\n"
    rows = [line(k, f"void spherepair::{kernel}<(int)128, (bool)1>(Params)", *counters.values())
            for k in range(3) for kernel in kernels]
    return line("ID", "Kernel Name", *counters) + line("", "", *("%" for _ in counters)) + "".join(rows)


TOOL = """#!{python}
import pathlib, sys
words = sys.argv[1:]
if "--version" in words:
    print("made-up tool\\nCuda compilation tools, release 13.0, V13.0.88")
elif "--export" in words:
    pathlib.Path(words[words.index("--export") + 1]).write_text(" ".join(words))
elif "--dump-resource-usage" in words or "--import" in words:
    print({first!r})
else:
    print({second!r})
"""


def make_tools(folder, csv=None):
    """Writes cuobjdump, nvdisasm and ncu into a folder, and returns the variables by which they are found."""
    folder = pathlib.Path(folder)
    for name, first in (("cuobjdump", "".join(functions())), ("nvdisasm", ""), ("ncu", csv or report())):
        path = folder / name
        path.write_text(TOOL.format(python=sys.executable, first=first, second=LOOP))
        path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return {**os.environ, "PATH": f"{folder}:{os.environ['PATH']}"}


class StandIn(unittest.TestCase):
    """A folder of records that paper/record makes with the stand-ins."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.home, self.folder = pathlib.Path(folder.name), pathlib.Path(folder.name, "machine")
        self.program = self.home / "stand_in"
        self.program.write_text(PROGRAM.format(python=sys.executable))
        self.program.chmod(self.program.stat().st_mode | stat.S_IXUSR)
        self.environment = make_tools(self.home)
        self.environment.pop("CUDA_VISIBLE_DEVICES", None)
        self.environment["TMPDIR"] = str(self.home)  # other recordings on this machine are none of the test's
        self.say()

    def say(self, memory=150 * 10**9, software=False, cuda=True, digests=None, **more):
        backends = [{"name": "cpu", "open": True}, {"name": "opengl", "open": True, "software": software},
                    {"name": "cuda", "open": cuda, "uuid": "A", "details": {"memory bytes": str(memory), "compute capability": "9.0"}},
                    {"name": "vulkan", "open": cuda, "uuid": "A", "software": software}]
        context = {"build": {"commit": "made-up"}, "sources": digests or sources.current()}
        said = {"devices": {"context": context, "backends": backends}, "fails": None, "sleeps": False, "text": None, "older_tests": False,
                "verdict": "equal", **more}
        (self.home / "said.json").write_text(json.dumps(said))

    def words(self, *words, program=None):
        program = program or self.program
        return [sys.executable, str(ROOT / "paper/record"), str(self.folder), "--program", str(program),
                "--tests", str(program), *words]

    def run_it(self, *words, code=0, **options):
        made = subprocess.run(self.words(*words, **options), capture_output=True, text=True, env=self.environment)
        self.assertEqual(code, made.returncode, made.stdout + made.stderr)
        return made.stdout + made.stderr

    def calls(self):
        path = self.home / "calls.txt"
        return [line.split()[1:] for line in path.read_text().splitlines()] if path.exists() else []

    def files(self):
        return {str(path.relative_to(self.folder)) for path in self.folder.rglob("*") if path.is_file()}
