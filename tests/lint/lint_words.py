#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Retired words: names and phrases of our own for what the field has a word for. A line that must name one says `retired:`.

To see those of a folder or file alone: lint_words.py [FOLDER or file ...]"""

import pathlib
import re
import sys

# Folders and files in which no retired word stands.
CHECKED = ("common", "shaders", "cuda", "glsl", "interop", "api", "bench", "tests", "docs", "README.md", "ARTIFACT.md", "paper")
SUFFIXES = (".h", ".cpp", ".cu", ".cuh", ".comp", ".vert", ".frag", ".glsl", ".py", ".cmake", ".md", ".txt")
OWN = ("lint_words.py", "lint_controls_text.py", "old_names.py")  # the tables, and the tests of this one

# (what is retired, what takes its place); upper and lower case are told apart in names only.
NAMES = (
    (r"\bWorld\b", "KernelBuffers"),
    (r"\bAsked\b|\beveryone\b", "Configuration, all_configurations"),
    (r"\bTricks?\b", "ApiOptions"),
    (r"\bmeet_\w+|\bmeet\(|\w_meet\b", "test_pair"),
    (r"(?<![\w.])touch\(", "add_contact"),
    (r"\bsettled?\(|\bsettled?_(?!on|down)\w+|\w+_settled?\b|`settle`|\bSETTLE", "resolve_undecided, resolved"),
    (r"\bnumber_of\b|\bNAMES_IN_\w+", "sphere_index, INDEX_IN_W"),
    (r"\bplace\(|\bPlace\b|\bplace_(?:of|in)\w*|`place`", "sorted_index, evaluate_positions, GridPosition"),
    (r"\blook_at_due\w*|\bdue_step\w*|\bdue\[", "event_driven, next_event_step"),
    (r"PUT_OFF|\bput_off\w*", "deferred by occlusion culling"),
    (r"\bdraw_(?:pyramid|seen|counts)\b", "draw_hiz_pyramid, draw_previously_visible, draw_statistics"),
    (r"\bwait_for_launch_before\b|\blet_launch_behind_begin\b", "grid_dependency_sync, trigger_dependent_launch"),
    (r"\bhand_?over\w*|\bHandOver\w*", "transfer (copied, registered, imported)"),
    (r"\bmeasure_skips\b|\bskips\.(?:json|csv|txt)\b", "ablate"),
)
PROSE = (
    (r"\bobjections?\b", "first mismatch"),
    (r"\bceilings?\b", "peak rate, roofline"),
    (r"\bmeet(?:s|ing|ings)?\b(?! the (?:plane|ground))", "test, collide, intersect, candidate pair"),
    (r"\bsettles? (?:the|what|that|those|these|it|pairs)\b", "decide, resolve"),
    (r"\bnumbers of the spheres\b|\bnumber of (?:the|that|this) sphere\b|\bsphere'?s'? numbers?\b", "sphere index"),
    (r"\bplaces? (?:in|of) (?:the |a )?(?:cell )?order\b|\b(?:at|by) places?\b", "sorted index"),
    (r"\b(?:put|puts|putting) (?:\w+ )?off\b", "defer"),
    (r"\bcrowd(?:s|ed)?\b", "oversized bucket"),
    (r"\bstretch(?:es|ed)?\b", "chunk, columns_per_group"),
    (r"\bbeside\b", "overlaps_previous; with, next to"),
    (r"\bhand(?:s|ed|ing)?-?(?: )?overs?\b", "transfer, copy, register, import"),
    (r"\bphotos?\b|\bpictures?\b", "image, frame"),
    (r"\bwhoever\b", "the sphere that, the thread that"),
    (r"\b(?:is|are|was|were|be|been|being) asked\b", "is requested, is tested"),
    (r"\bwalk(?:s|ed)? (?:through|on|all)\b", "loop over, test"),
)
TABLE = [(re.compile(pattern), instead) for pattern, instead in NAMES]
TABLE += [(re.compile(pattern, re.I), instead) for pattern, instead in PROSE]


def files(root, names):
    found = []
    for name in names:
        path = root / name
        found += sorted(path.rglob("*")) if path.is_dir() else [path]
    return [p for p in dict.fromkeys(found) if p.is_file() and p.suffix in SUFFIXES and p.name not in OWN and kept(p, root)]


def kept(path, root):
    """Of paper/ the scripts only; no recorded data."""
    inside = path.relative_to(root).parts
    return inside[0] != "paper" or path.suffix == ".py" and "data" not in inside


def breaches(text):
    """(number of the line, the word, what takes its place)"""
    for number, line in enumerate(text.splitlines(), 1):
        if "retired:" in line:
            continue
        found = {match.start(): (match[0], instead) for pattern, instead in TABLE for match in pattern.finditer(line)}
        for start in sorted(found):
            yield (number, *found[start])


def words(root, build, names=CHECKED):
    checked = files(root, names)
    complaints = [f"{path.relative_to(root)}:{number}: `{word}` is retired: {instead}"
                  for path in checked for number, word, instead in breaches(path.read_text())]
    if not checked:
        complaints.append("no files found")
    return complaints, f"{len(checked)} files"


def main():
    root = pathlib.Path(__file__).resolve().parents[2]
    complaints, checked = words(root, None, sys.argv[1:] or CHECKED)
    print("\n".join(complaints))
    rooms = [str(pathlib.PurePath(complaint.split(":")[0]).parent) for complaint in complaints]
    for room in sorted(set(rooms)):
        print(f"{rooms.count(room):5} {room}")
    print(f"{len(complaints)} retired words in {checked}")


if __name__ == "__main__":
    main()
