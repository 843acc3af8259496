# SPDX-License-Identifier: MIT
"""The stress catalogue: its recorded tests, row by row."""
import re
from dataclasses import dataclass

from paper.records import Missing

ROWS = range(1, 34)  # of the catalogue


@dataclass
class Stressed:
    """One test of a row of the catalogue, on every backend that it ran on."""
    row: int
    scene: str
    what: str
    bound: str
    verdicts: dict  # backend, or all -> verdict
    figures: dict


def in_thousands(text):
    """10000000 -> 10,000,000, where it is a number of its own."""
    return re.sub(r"(?<![\w.,^+-])\d{5,}(?![\w.])", lambda number: f"{int(number[0]):,}", text)


def in_words(name):
    """A number is a word of its own."""
    return in_thousands(re.sub(r"([a-z])(\d)", r"\1 \2", name))


def stressed(machine):
    tests = {}
    for entry in machine.source("stress.json")["rows"]:
        test = tests.setdefault((entry["row"], entry["what"]), Stressed(
            entry["row"], entry["scene"], in_words(entry["what"]), entry["bound"], {}, {}))
        test.verdicts[entry["backend"]] = entry["verdict"]
        if entry["verdict"] != "skipped":
            test.figures[entry["backend"]] = in_thousands(entry["figure"])
    found = list(tests.values())
    failed = [f"{test.row}: {test.what}" for test in found if "FAIL" in test.verdicts.values()]
    if failed:
        raise Missing(f"{machine.name}: rows of the stress catalogue failed, {', '.join(failed)}")
    absent = [str(row) for row in ROWS if not any(test.row == row and test.figures for test in found)]
    if absent:
        raise Missing(f"{machine.name}: rows {', '.join(absent)} of the stress catalogue were not run")
    return found


def places(machine):
    """The machines and commits that the parts of the record name, each once; none of a part without context."""
    contexts = machine.source("stress.json").get("contexts", ())
    return list(dict.fromkeys(host_and_commit(context) for context in contexts if context))


def host_and_commit(context):
    host = context["machine"]
    return f"{host['cpu'].replace('(R)', '')} with {host['hardware_threads']} hardware threads, commit {context['build']['commit'][:12]}"


def recorded_stress(machines):
    """The first machine that has a record of the catalogue."""
    found = [machine for machine in machines if "stress.json" in machine.sources]
    if not found:
        raise Missing("no machine has a stress.json")
    return found[0]
