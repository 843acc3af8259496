# SPDX-License-Identifier: MIT
"""Draws every figure that recorded runs allow."""
import importlib
import pkgutil
from dataclasses import dataclass
from typing import Any, Optional

from paper import images, plots, style
from paper.records import Missing

ROOMS = (images, plots)  # images were rendered beforehand and are the same for every machine


@dataclass
class Drawn:
    name: str
    caption: Optional[str]  # LaTeX; None if the records lack what it states
    source: str  # hardware and runs
    note: str  # what of the records is stale
    figure: Any


def modules(rooms=ROOMS):
    names = [f"{room.__name__}.{found.name}" for room in rooms for found in pkgutil.iter_modules(room.__path__)]
    return [importlib.import_module(name) for name in sorted(names, key=lambda name: name.rpartition(".")[2])]


def runs_of(module, machine):
    """The ids of the sources of a figure that was just drawn: those that it names, or those of the records that it used."""
    named = module.source(machine) if hasattr(module, "source") else ""
    used = {record.source for record in machine.used.values()}
    return machine.ids_in(named) or machine.ids_in(" ".join(used)) or [machine.id]


def with_note(source, note):
    return f"{source}; {note}" if note else source


def caption_of(module, machine):
    try:
        return module.caption(machine) if hasattr(module, "caption") else module.CAPTION
    except Missing:
        return None


def drawn(module, machine):
    machine.used.clear()
    figure = module.draw(machine)
    machine.runs[module.NAME] = runs_of(module, machine)
    source = machine.title_of(machine.runs[module.NAME])
    note = machine.note_on(module.NAME, source if hasattr(module, "source") else "")
    return Drawn(module.NAME, caption_of(module, machine), source, note, figure)


def made(machine, announce=lambda name: None, rooms=ROOMS):
    """Each figure, or its name and the reason why it cannot be drawn."""
    style.name_devices(machine)
    for module in modules(rooms):
        announce(module.NAME)
        try:
            yield drawn(module, machine), None
        except Missing as reason:
            yield None, (module.NAME, str(reason))
