#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Puts deliberate faults into the code, one at a time, and says which tests find them.

    tests/mutants/mutants.py [--only NAME ...] [--workers N] [--output FILE] [--resume]

Each mutant of mutant_list.py is put into a copy of the tree under build/mutants, built without CUDA and given to the ctest
entries that it names, then, where it survives those, to all of ./check's that run without CUDA. The results go to
tests/mutants/results.txt; the exit status is 1 when fewer than 95 % of the mutants were killed.
A run that was stopped goes on with --resume.
"""
import argparse
import concurrent.futures
import pathlib
import queue
import re
import shutil
import subprocess
import sys
import time

from mutant_list import MUTANTS

ROOT = pathlib.Path(__file__).resolve().parents[2]
TARGETS = ["spherepair", "spherepair_faulty", "spherepair_tests"]
NEEDED = 0.95
SLOWEST = 1800  # seconds that all tests together may take; a mutant that hangs is killed, too


class Tree:
    """A copy of the tree with a build of its own."""

    def __init__(self, folder):
        self.folder, self.build = folder, folder / "build"
        files = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT,
                               check=True, capture_output=True, text=True).stdout
        names = set(filter(None, files.split("\0")))
        for path in folder.rglob("*"):  # of an earlier tree
            if path.is_file() and self.build not in path.parents and str(path.relative_to(folder)) not in names:
                path.unlink()
        for name in sorted(names):
            source, target = ROOT / name, folder / name
            if not source.is_file():
                continue
            if target.exists() and target.read_bytes() == source.read_bytes():
                continue
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source, target)
            shutil.copymode(source, target)
        self.run(["cmake", "-S", ".", "-B", "build", "-G", "Ninja", "-D", "CMAKE_BUILD_TYPE=Release",
                  "-D", "CMAKE_CUDA_COMPILER=NOTFOUND"], check=True)

    def run(self, command, check=False, timeout=None):
        try:
            done = subprocess.run(command, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                  errors="replace", timeout=timeout)
        except subprocess.TimeoutExpired:
            return 124, "no end after %d s" % timeout
        if check and done.returncode:
            sys.exit("%s failed in %s:\n%s" % (" ".join(command), self.folder, done.stdout[-4000:]))
        return done.returncode, done.stdout

    def make(self):
        return self.run(["cmake", "--build", "build", "--parallel", "2", "--target", *TARGETS])

    def test(self, entries):
        """The name of the first test that fails, or None."""
        pattern = ["-R", "^(%s)" % "|".join(map(re.escape, entries))] if entries else ["-E", "^(lint[.]|paper[.]|fuzz[.])"]  # not built
        status, said = self.run(["ctest", "--test-dir", "build", "--stop-on-failure", "--output-on-failure",
                                 "--no-tests=error", *pattern], timeout=SLOWEST)
        if status == 0:
            return None
        failed = re.findall(r"\[  FAILED  \] (\S+)", said) or re.findall(r"\d+ - (\S+) \(", said)  # it may have crashed
        return failed[0].rstrip(",") if failed else said.strip().splitlines()[-1][:80]


def check(mutant):
    """Exactly one place of the file has the mutant's text."""
    text = (ROOT / mutant["file"]).read_text()
    if text.count(mutant["old"]) != 1:
        sys.exit("%s: '%s' stands %d times in %s, not once" % (mutant["name"], mutant["old"], text.count(mutant["old"]), mutant["file"]))


def try_mutant(mutant, tree):
    file = tree.folder / mutant["file"]
    right = file.read_text()
    start = time.monotonic()
    file.write_text(right.replace(mutant["old"], mutant["new"]))
    try:
        status, said = tree.make()
        if status:
            return "is no program: " + next((line for line in said.splitlines() if "error" in line), said[-200:])
        killer = tree.test(mutant["tests"]) or tree.test([])
        return "killed by %s after %.0f s" % (killer, time.monotonic() - start) if killer else "SURVIVED"
    finally:
        file.write_text(right)


def line_of(mutant, result):
    return "%-42s %-38s %s" % (mutant["name"], mutant["file"], result)


def earlier_results(mutants, file):
    """By name, what the file says of these mutants."""
    lines = file.read_text().splitlines() if file.exists() else []
    heads = {m["name"]: line_of(m, "") for m in mutants}
    return {name: line[len(head):] for name, head in heads.items() for line in lines if line.startswith(head)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", nargs="+", default=[], metavar="NAME", help="these mutants, and no results are written")
    parser.add_argument("--workers", type=int, default=1, help="copies of the tree that are worked on at a time")
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path(__file__).with_name("results.txt"))
    parser.add_argument("--resume", action="store_true", help="keep the results that the file has, and try the other mutants")
    options = parser.parse_args()
    mutants = [m for m in MUTANTS if not options.only or m["name"] in options.only]
    unknown = set(options.only) - {m["name"] for m in MUTANTS}
    if unknown:
        sys.exit("no mutant has the name %s" % ", ".join(sorted(unknown)))
    for mutant in mutants:
        check(mutant)
    trees = queue.Queue()
    for k in range(options.workers):
        tree = Tree(ROOT / "build" / "mutants" / str(k))
        status, said = tree.make()
        if status:
            sys.exit("the tree as it is cannot be built:\n" + said[-4000:])
        trees.put(tree)
    used = sorted({entry for mutant in mutants for entry in mutant["tests"]})
    tree = trees.get()
    failing = tree.test(used)
    trees.put(tree)
    if failing:
        sys.exit("%s fails without a mutant" % failing)

    done = earlier_results(mutants, options.output) if options.resume else {}

    def write():
        killed = sum(result.startswith("killed") for result in done.values())
        lines = [line_of(m, done[m["name"]]) for m in mutants if m["name"] in done]
        lines.append("\n%d of %d mutants killed" % (killed, len(done)))
        if not options.only:
            options.output.write_text("\n".join(lines) + "\n")
        return killed, lines[-1]

    def one(mutant):
        if mutant["name"] in done:
            return
        tree = trees.get()
        try:
            result = try_mutant(mutant, tree)
        finally:
            trees.put(tree)
        print("%-42s %s" % (mutant["name"], result), flush=True)
        done[mutant["name"]] = result
        write()

    with concurrent.futures.ThreadPoolExecutor(options.workers) as pool:
        list(pool.map(one, mutants))
    killed, summary = write()
    print(summary)
    return 0 if killed >= NEEDED * len(mutants) else 1


if __name__ == "__main__":
    sys.exit(main())
