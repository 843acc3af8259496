# SPDX-License-Identifier: MIT
"""The recorded test suite as a table: tests by backend, and the adversarial pairs that each decided."""
from paper import parts
from paper.numbers.suite import suite as recorded_suite
from paper.tables.tabular import Table
from paper.text import APIS

CAPTION = ("The whole test suite on this machine, at commit {commit}, {date}: tests by the backend that their names end with, each name "
           "once, and the adversarial pairs that they decided. No test failed.")


def suite(machine):
    found, rows = recorded_suite(machine), []
    for backend in (*parts.BACKENDS, ""):
        pairs, ties = found.decided(backend)
        rows.append([APIS.get(backend, "none of the three"), str(found.of(backend, "OK")), str(found.of(backend, "SKIPPED")),
                     f"{pairs:,}" if pairs else "-", f"{ties:,}" if pairs else "-"])
    heads = [[("", 1), ("tests", 2), ("adversarial pairs", 2)], ["backend", "passed", "skipped", "all", "exact ties"]]
    return Table("suite", CAPTION.format(commit=found.commit[:12], date=found.dates[0][:10]), heads, rows, left=1, source=found.source)
