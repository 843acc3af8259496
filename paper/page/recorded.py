# SPDX-License-Identifier: MIT
"""The figures of recorded runs, drawn once: kept in build/recorded until anything that they can depend on changes."""
import hashlib
import json
import shutil
from pathlib import Path

import matplotlib

from paper import sources
from paper.page import report
from paper.records import Machine

ROOT = Path(__file__).resolve().parents[2]
KEPT = ROOT / "build/recorded"


def depends_on(folder, paper=ROOT / "paper"):
    """Everything under paper/ except the records of other machines."""
    others = [path for path in (paper / "data").iterdir() if (path / "results").is_dir() and path.resolve() != folder.resolve()]
    return [path for path in sorted(paper.rglob("*")) if path.is_file() and "__pycache__" not in path.parts
            and not any(other in path.parents for other in others)]


def digest(folder, paper=ROOT / "paper"):
    """Of those files, of the sources that records are compared with, and of matplotlib's version."""
    made = hashlib.sha256(json.dumps([matplotlib.__version__, sources.current()], sort_keys=True).encode())
    for path in depends_on(folder, paper):
        made.update(f"{path.relative_to(paper)}\0".encode() + hashlib.sha256(path.read_bytes()).digest())
    return made.hexdigest()[:16]


def taken(folder, output, progress, kept=KEPT):
    """The report of a recorded machine, with its figures copied to `output`; they are drawn only if none are kept."""
    made = kept / f"{folder.name}-{digest(folder)}"
    finished = made / "report.json"  # written last
    if finished.exists():
        progress.note(f"{folder.name}: the figures in {made} are up to date")
    else:
        for old in kept.glob(f"{folder.name}-*"):
            shutil.rmtree(old)
        finished.write_text(report.make(Machine(folder), made, progress).text())
    shutil.copytree(made, output, dirs_exist_ok=True)
    return report.from_text(finished.read_text())
