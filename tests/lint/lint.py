#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Rules that a compiler does not check, one a run: lint.py RULE [--build FOLDER]. No GPU is needed.

Exits 0 when the rule holds, 1 after naming every breach, and 77 with the reason when a tool is missing."""

import argparse
import pathlib
import sys

import lint_arithmetic
import lint_rooms
import lint_sources
import lint_twins

RULES = {
    "rooms": lint_rooms.rooms,
    "twins": lint_twins.twins,
    "files": lint_sources.files,
    "headers": lint_sources.headers,
    "borders": lint_sources.borders,
    "builtins": lint_sources.builtins,
    "functions": lint_sources.functions,
    "mutants": lint_sources.mutants,
    "format": lint_sources.formatting,
    "shaders": lint_arithmetic.shaders,
    "ptx": lint_arithmetic.ptx,
    "oldest": lint_arithmetic.oldest,
    "flags": lint_arithmetic.flags,
}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("rule", choices=RULES)
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[2])
    parser.add_argument("--build", type=pathlib.Path, help="build folder: compile_commands.json and flattened/")
    options = parser.parse_args()
    try:
        complaints, checked = RULES[options.rule](options.root, options.build)
    except lint_sources.Skip as reason:
        print(f"SKIPPED: {reason}")
        return 77
    for complaint in complaints:
        print(complaint)
    print(f"{options.rule}: {len(complaints)} breaches in {checked}")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
