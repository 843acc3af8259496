# SPDX-License-Identifier: MIT
"""The recorded test suite: what passed, by the names of the tests, and the adversarial pairs of each backend."""
import re
from dataclasses import dataclass

from paper import ids, parts
from paper.records import Missing, digest

HEAD = re.compile(r"^commit: (\S+)\ndate: (\S+)$", re.MULTILINE)
ENDED = re.compile(r"^\[==========\] (\d+) tests? from .* ran\.", re.MULTILINE)
RESULT = re.compile(r"^\[ +(OK|SKIPPED|FAILED) +\] ([^\s,]+)(?:, where .*)? \(\d+ ms\)$|^\[ RUN      \] (\S+)$|^\w+: (\d+) pairs, (\d+) ties",
                    re.MULTILINE)
BACKEND = re.compile(rf"(.*)/({'|'.join(parts.BACKENDS)})")


@dataclass(frozen=True)
class Suite:
    commit: str
    dates: list
    source: str
    verdicts: dict  # name of a test -> OK, SKIPPED or FAILED
    pairs: dict  # name of a test -> (adversarial pairs, exact ties among them)

    def of(self, backend, verdict):
        """How many tests of a backend, or with "" of none, have this verdict."""
        return sum(backend_of(name) == backend and found == verdict for name, found in self.verdicts.items())

    def decided(self, backend):
        """(pairs, ties) that a backend decided."""
        found = [pairs for name, pairs in self.pairs.items() if backend_of(name) == backend]
        return tuple(map(sum, zip(*found))) if found else (0, 0)


def backend_of(name):
    match = BACKEND.fullmatch(name)
    return match[2] if match else ""


def results_of(text):
    """(test -> verdict, test -> pairs and ties) that one output tells."""
    verdicts, pairs, running = {}, {}, None
    for match in RESULT.finditer(ids.OLD_TEST.sub("/opengl", text)):
        verdict, ended, started, count, ties = match.groups()
        if started:
            running = started
        elif ended:
            verdicts[ended] = verdict
        else:
            pairs[running] = (int(count), int(ties))
    return verdicts, pairs


def defect(name, text):
    """Why one output is not that of a whole run of a known commit, or nothing."""
    if not HEAD.search(text):
        return f"{name} names no commit and date"
    ended = ENDED.search(text)
    if not ended or int(ended[1]) != len(results_of(text)[0]):
        return f"{name} does not hold the result of each of its tests"
    return ""


def lacking(verdicts):
    """Tests that take a backend and were not run with each."""
    found = {}
    for name in verdicts:
        if backend_of(name):
            found.setdefault(BACKEND.fullmatch(name)[1], set()).add(backend_of(name))
    return sorted(name for name, backends in found.items() if len(backends) < len(parts.BACKENDS))


def suite(machine):
    """Refuses a record in which an output or a backend is missing, or whose outputs are of several commits."""
    wanted = {target.removeprefix("tests/") for part in parts.GPU if part.name.startswith("tests-") for target in part.files.values()}
    texts = {path.name: path.read_text(errors="replace") for path in sorted(machine.folder.glob("tests/*.txt"))
             if not path.name.startswith("contacts_")}
    if texts.keys() != wanted:
        raise Missing(f"{machine.name}: the suite is {', '.join(sorted(wanted))}, but tests/ holds {', '.join(texts) or 'nothing'}: "
                      "remove what is older and record the parts tests-*")
    defects = list(filter(None, (defect(*item) for item in texts.items())))
    commits = {HEAD.search(text)[1] for text in texts.values() if HEAD.search(text)}
    verdicts, pairs = results_of("\n".join(texts.values()))
    defects += [f"its outputs are of {len(commits)} commits"] * (len(commits) > 1)
    defects += [f"{name} failed" for name, verdict in verdicts.items() if verdict == "FAILED"]
    defects += [f"{name} was not run with each backend" for name in lacking(verdicts)]
    if defects:
        raise Missing(f"{machine.name}, suite in tests/: {'; '.join(defects[:4])}")
    found = Suite(*commits, sorted(HEAD.search(text)[2] for text in texts.values()),
                  f"{machine.name}:{digest(''.join(texts.values()).encode())}", verdicts, pairs)
    if len({found.decided(backend) for backend in parts.BACKENDS}) != 1:
        raise Missing(f"{machine.name}, suite in tests/: the backends decided unequal numbers of adversarial pairs")
    return found
