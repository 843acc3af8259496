# SPDX-License-Identifier: MIT
"""The numbers of the paper's prose: each a LaTeX macro with the run it comes from.

paper.tex uses \\Nr{key}. The build fails if a key is not made here from a recorded run, and for any other digit in the
prose except in mathematics and in \\given{...}.
"""
import re
import sys

from paper.numbers.prose_accuracy import ACCURATE
from paper.numbers.prose_apis import COMPARED_APIS
from paper.numbers.prose_compared import COMPARED
from paper.numbers.prose_contacts import CONTACTS
from paper.numbers.prose_equality import EQUALITY
from paper.numbers.prose_leads import LEADING
from paper.numbers.prose_limits import LIMITS
from paper.numbers.prose_measured import MEASURED
from paper.numbers.prose_studies import STUDIED
from paper.records import Missing
from paper.text import escape


GIVEN = {  # \\given{...}, which no run gives: where it stands
    "590": "the original's GPU", "1": "the original's Table 1", "60": "the original's frame rate, in its text",
    "180": "faces of glutSolidSphere in its code", "80": "faces of its mesh", "4.50": "version of GLSL, shaders/",
    "16": "undecided pairs that a group keeps, shaders/collide/collide_grid.comp", "2": "MiB, least imported buffer, glsl/device_limits.cpp",
    "64": "bits of a hash and of a state; ticks a second of a system's timer", "0.3": "packing fraction, paper/parts.py",
    "0.5": "%, aim of the longest batch, prose_equality.AIM", "95": "%, level of intervals", "32": "threads of a group", "128": "threads of a group",
    "1.2": "bound of a good choice, prose_compared.GOOD", "66": "texture processing clusters of an H100, its white paper"}
SENTENCE = 60  # characters from which the appendix lists the key without the text


class Numbers:
    """key -> (text, id of the run, description)."""

    def __init__(self):
        self.entries, self.left_out = {}, []

    def put(self, key, text, source, how):
        if key in self.entries:
            raise ValueError(f"the number {key} is made twice")
        text = re.sub(r"(?<=\d),(?=\d)", "{,}", text)
        self.entries[key] = (re.sub(r"(?<!\\)_", r"\\_", text), source, how)


MAKERS = (*MEASURED, *LEADING, *EQUALITY, *STUDIED, *ACCURATE, *COMPARED, *CONTACTS, *LIMITS)


def collect(machine, others, three=None, makers=MAKERS):
    """Of a machine, of others that are compared with it, and of one that timed three APIs, if there is one."""
    numbers = Numbers()
    for make in (*makers, *(COMPARED_APIS if three else ())):
        try:
            make(numbers.put, three if make in COMPARED_APIS else machine, others)
        except Missing as reason:
            numbers.left_out.append((make.__name__, str(reason)))
    return numbers


def without_unrecorded(tex, recorded):
    """Drops \\ifrecorded{name}{text} if the figure or table `name` was not made, as LaTeX does."""
    start = re.compile(r"\\ifrecorded\{([\w-]+)\}\{")
    found = start.search(tex)
    while found:
        depth, end = 1, found.end()
        while depth:
            depth += {"{": 1, "}": -1}.get(tex[end], 0)
            end += 1
        text = tex[found.end():end - 1] if found[1] in recorded else ""
        tex = tex[:found.start()] + text + tex[end:]
        found = start.search(tex)
    return tex


def body_of(tex, recorded=()):
    """The prose: without comments, preamble and bibliography."""
    tex = re.sub(r"(?<!\\)%.*", "", tex)
    start, end = tex.index("\\begin{abstract}"), tex.index("\\begin{thebibliography}")
    return without_unrecorded(tex[start:end], recorded)


def used_keys(tex, recorded=()):
    return list(dict.fromkeys(re.findall(r"\\Nr\{([^}]*)\}", body_of(tex, recorded))))


def stray_digits(tex, recorded=()):
    """Lines with digits that are neither generated nor marked as given."""
    prose = body_of(tex, recorded)
    commands = r"\\(Nr|given|cite|ref|label|url|texttt|recorded\w+|ifrecorded|begin|end)(\[[^]]*\])?\{[^{}]*\}"
    for pattern in (r"\\begin\{equation\}.*?\\end\{equation\}", r"\$[^$]*\$", commands):
        prose = re.sub(pattern, "", prose, flags=re.DOTALL)
    return [line.strip() for line in prose.splitlines() if re.search(r"(?<![A-Za-z\d])\d", line)]


def unknown_given(tex, recorded=()):
    return sorted(set(re.findall(r"\\given\{([^}]*)\}", body_of(tex, recorded))) - GIVEN.keys())


def check(tex, numbers, recorded=()):
    given, missing = unknown_given(tex, recorded), [key for key in used_keys(tex, recorded) if key not in numbers.entries]
    stray = stray_digits(tex, recorded)
    for key in missing:
        print(f"paper.tex uses \\Nr{{{key}}}, which no recorded run gives", file=sys.stderr)
    for number in given:
        print(f"paper.tex has \\given{{{number}}}, which GIVEN in paper/numbers/macros.py does not list with its source", file=sys.stderr)
    for line in stray:
        print(f"paper.tex has a number with no run behind it: {line}", file=sys.stderr)
    if missing or stray or given:
        for name, reason in numbers.left_out:
            print(f"  the numbers of {name} are missing: {reason}", file=sys.stderr)
        raise Missing("the paper's numbers are not all recorded")


def write(numbers, tex, path, recorded=()):
    lines = ["% Made by paper/numbers/macros.py from recorded runs; one line per number: key, text, run, description."]
    for key, (text, source, how) in numbers.entries.items():
        lines.append(f"\\definenumber{{{key}}}{{{text}}}{{{source}}}{{{escape(how)}}}")
    path.write_text("\n".join(lines) + "\n")
    trace = [f"\\traced{'text' if len(numbers.entries[key][0]) > SENTENCE else ''}{{{key}}}"
             for key in used_keys(tex, recorded)]
    path.with_name("trace.tex").write_text("\n".join(trace) + "\n")
