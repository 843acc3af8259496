# SPDX-License-Identifier: MIT
"""What the page shows of one machine: its figures as PNG files, its tables as HTML, its verdict and its answer."""
import json
from dataclasses import asdict, dataclass, field

from paper import all_figures, images, plots, style
from paper.page import answer
from paper.page.html_table import as_html
from paper.records import DATA, Missing
from paper.tables import all_tables
from paper.text import APIS, plain

PIXELS = 110  # of the page, an inch of a figure


@dataclass
class Item:
    name: str
    caption: str  # may be empty
    source: str
    size: tuple = ()  # of a figure on the page, in CSS pixels
    table: str = ""  # HTML
    rendered: bool = False  # an image that no machine of the page made


@dataclass
class Report:
    name: str
    device: str
    recorded: bool  # in paper/data, as opposed to this machine
    equal: str
    backends: list
    warnings: list
    answer: tuple = ()  # in words, and with the ratios; empty if the machine cannot say
    why_not: str = ""
    items: list = field(default_factory=list)
    left_out: dict = field(default_factory=dict)  # name -> reason

    @property
    def compares_apis(self):
        return bool(self.answer)

    def item(self, name):
        return next((item for item in self.items if item.name == name), None)

    def text(self):
        return json.dumps(asdict(self), indent=1)


def from_text(text):
    values = json.loads(text)
    return Report(**{**values, "items": [Item(**item) for item in values["items"]]})


def is_recorded(folder):
    return folder.resolve().parent == DATA


def backends_of(machine):
    """A line each: OpenGL: llvmpipe (software); CUDA: not run, and why."""
    def line(backend):
        if not backend.get("open", True):
            return f"did not run: {backend['reason']}"
        return backend["device"] + (", in software" if backend.get("software") else "")

    return [f"{APIS[backend['name']]}: {line(backend)}" for backend in machine.main.get("backends", ())]


def equality(machine):
    """What was compared and found equal, or the verdict of a run that did not get there."""
    root = machine.main
    made = {kind: sum(counts[kind]["made"] for counts in root.get("comparisons", {}).values() if kind in counts)
            for kind in ("sets", "states")}
    if root.get("verdict") != "equal":
        return f"Not confirmed: the run's verdict is {root.get('verdict', 'missing')}."
    names = [APIS[backend["name"]] for backend in root.get("backends", ()) if backend.get("open", True)]
    where = " and ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names)
    return f"Equal: {made['sets']:,} sets of pairs and {made['states']:,} states of the spheres, on {where}."


def warnings_of(machine):
    lost = f"{machine.lost} timings are left out: their noise is greater than they are, as on a busy machine."
    return [*machine.main.get("warnings", ()), *([lost] if machine.lost else ())]


def figures_of(machine, folder, progress, rooms):
    rendered = {module.NAME for module in all_figures.modules((images,))}
    for made, reason in all_figures.made(machine, lambda name: progress.start(f"{machine.name}: {name}"), rooms):
        if reason:
            yield None, reason
            continue
        style.save_png(made.figure, folder / f"{made.name}.png")
        size = tuple(round(PIXELS * inches) for inches in made.figure.get_size_inches())
        style.plt.close(made.figure)
        yield Item(made.name, plain(made.caption or ""), all_figures.with_note(made.source, made.note), size,
                   rendered=made.name in rendered), None


def device(machine):
    return machine.short.rpartition(", run ")[0]


def caption_of(table, machine):
    """Without LaTeX; one that ends with a colon goes on with the device."""
    text = plain(table.caption)
    return f"{text} {device(machine)}." if text.endswith(":") else text


def tables_of(machine, progress):
    progress.start(f"{machine.name}: tables")
    for made, reason in all_tables.made(machine):
        yield (None, (reason[0].replace("_", "-"), reason[1])) if reason else (
            Item(made.name, caption_of(made, machine), all_tables.table_title(made, machine), table=as_html(made)), None)


def make(machine, folder, progress):
    """Draws and writes what the records allow."""
    folder.mkdir(parents=True, exist_ok=True)
    recorded = is_recorded(machine.folder)
    report = Report(machine.name, device(machine), recorded, equality(machine), backends_of(machine),
                    warnings_of(machine), why_not=answer.why_not(machine))
    try:
        report.answer = answer.answer(machine, recorded)
    except Missing as reason:
        progress.note(f"no answer: {reason}")
    for item, reason in (*figures_of(machine, folder, progress, (images, plots) if recorded else (plots,)),
                         *tables_of(machine, progress)):
        if item:
            report.items.append(item)
        else:
            report.left_out[reason[0]] = reason[1]
            progress.note(f"{machine.name}: {reason[0]} is left out: {reason[1]}")
    progress.end()
    return report
