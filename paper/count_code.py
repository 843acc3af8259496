#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The code of each API: lines of every kernel in both languages and of the host code, and nvcc's time per kernel.

  paper/count_code.py --output paper/data/code.json [--build build/check]

Lines are counted without blank lines and comments. nvcc's time is processor time, which a busy machine hardly changes:
the minimum of several compilations by the command in BUILD/compile_commands.json. Without such a build or without nvcc
the times are left out.
"""
import argparse
import datetime
import difflib
import json
import platform
import re
import resource
import shlex
import subprocess
from pathlib import Path

SHARED_ARITHMETIC = ("predicate", "exact", "motion", "cell")
ROOT = Path(__file__).resolve().parent.parent


def code_lines(path):
    text = re.sub(r"/\*.*?\*/", "", path.read_text(), flags=re.DOTALL)
    lines = (re.sub(r"//.*", "", line).strip() for line in text.splitlines())
    return [line for line in lines if line]


def total(*patterns):
    return sum(len(code_lines(path)) for pattern in patterns for path in sorted(ROOT.glob(pattern)))


def same_lines(left, right):
    """Number of common lines, in the same order."""
    return sum(block.size for block in difflib.SequenceMatcher(None, left, right, False).get_matching_blocks())


def processor_seconds(command, folder):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def compile_seconds(build, rounds):
    """Kernel -> processor seconds of its nvcc command; the object is discarded."""
    commands = build / "compile_commands.json"
    if not commands.exists():
        return {}
    seconds = {}
    for entry in json.loads(commands.read_text()):
        file = Path(entry["file"])
        if file.suffix != ".cu":
            continue
        words = shlex.split(entry["command"])
        words[words.index("-o") + 1] = "/dev/null"
        nvcc = [word for word in words if "ccache" not in Path(word).name]
        seconds[file.stem] = min(processor_seconds(nvcc, entry["directory"]) for _ in range(rounds))
    return seconds


def twins(seconds):
    for shader in sorted((ROOT / "shaders").rglob("*.comp"), key=lambda path: path.stem):
        folder = shader.parent.relative_to(ROOT / "shaders")
        glsl, cuda = code_lines(shader), code_lines(ROOT / "cuda" / folder / f"{shader.stem}.cu")
        row = {"kernel": shader.stem, "glsl_lines": len(glsl), "cuda_lines": len(cuda),
               "same_lines": same_lines(glsl, cuda)}
        if shader.stem in seconds:
            row["nvcc_seconds"] = round(seconds[shader.stem], 3)
        yield row


def context():
    def run(*words):
        return subprocess.run(words, cwd=ROOT, capture_output=True, text=True).stdout.strip()

    cpu = re.search(r"model name\s*:\s*(.*)", Path("/proc/cpuinfo").read_text())
    changed = " with changes" if run("git", "status", "--porcelain", "--untracked-files=no") else ""
    return {"date": datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ"),
            "commit": run("git", "rev-parse", "HEAD") + changed,
            "cpu": cpu[1] if cpu else platform.processor(), "load_average": Path("/proc/loadavg").read_text().strip()}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", type=Path, required=True, help="the JSON file to write")
    parser.add_argument("--build", type=Path, default=ROOT / "build/check", help="a build with compile_commands.json")
    parser.add_argument("--rounds", type=int, default=2, help="compilations of each kernel")
    options = parser.parse_args()
    seconds = compile_seconds(options.build, options.rounds)
    result = {"format": "spherepair code 1", "context": context(), "twins": list(twins(seconds)),
              "support": {"glsl": total("shaders/**/*.glsl"), "cuda": total("cuda/**/*.cuh")},
              "host": {"opengl": total("glsl/*.cpp", "glsl/*.h"), "vulkan": total("vulkan/**/*.cpp", "vulkan/**/*.h"),
                       "cuda": total("cuda/**/*.cpp", "cuda/**/*.h")},
              "shared": {"arithmetic": total(*(f"common/shared/{name}.h" for name in SHARED_ARITHMETIC)),
                         "host": total(*(f"common/{room}/*.{kind}" for room in ("device", "simulation") for kind in ("cpp", "h")))}}
    options.output.write_text(json.dumps(result, indent=1) + "\n")
    print(f"{len(result['twins'])} twins, {len(seconds)} of them compiled: {options.output}")


if __name__ == "__main__":
    main()
