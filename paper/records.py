# SPDX-License-Identifier: MIT
"""Recorded runs, as the figures, tables and numbers of the paper read them.

A folder under paper/data is one machine. Every JSON file in it is a source, and so is every folder of JSON files: of a
sweep, or of several processes, which are numbered. A source's id is the machine's name and the first 8 hexadecimal
digits of the SHA-256 of its bytes. One record is one measurement: what was run (any parameters the writer chose), its
samples, median and interval in milliseconds, and the source it came from; formats.py reads the files of each program,
and spread.py merges the records of several processes.
"""
import hashlib
import json
from dataclasses import dataclass, field
from pathlib import Path

from paper import batches, formats, ids, sources, spread
from paper.folders import host_of, sources_in
from paper.spread import summary

DATA = Path(__file__).resolve().parent / "data"
MAIN = "h100"  # the machine of the paper
APIS = "apis"  # one on which OpenGL, Vulkan and CUDA were timed in turns
TABLES = {"sweep_tensor": "tensor", "sweep_spirv": "spirv", "sweep_core": "core_grid", "precision_core": "core_motion", "ablate_extensions": "extension"}  # of their own


class Missing(Exception):
    """What a figure, table or number needs is not among the recorded runs."""


def said(machine, holds, what):
    """Refuses the numbers, and with them the paper, if the records contradict what the prose states."""
    if not holds:
        raise Missing(f"{machine.name}: the text says that {what}, and the records do not")


@dataclass(frozen=True)
class Record:
    parameters: dict = field(repr=False)
    median: float  # ms
    low: float
    high: float
    source: str
    date: str = ""  # of the run
    swept: bool = False  # by `spherepair sweep`, which uses the group size that is chosen for n
    recorded: tuple = field(default=(), repr=False)  # digests of the sources in each of its files, see sources.py

    def __getattr__(self, name):
        if name in self.parameters:
            return self.parameters[name]
        raise AttributeError(name)

    def matches(self, wanted):
        own = self.parameters
        return all(value == (own[name] if name in own and name != "scene" else
                             own.get("scene", {}).get("name" if name == "scene" else name))
                   for name, value in wanted.items())


def steady(*records):
    """Whether all may decide: the program marks times of a busy machine and those with an interval wider than 2x."""
    return not any(record.parameters.get("unsteady") for record in records)


def text_of(wanted):
    return ", ".join(f"{name} {value}" for name, value in wanted.items())


def digest(raw):
    return hashlib.sha256(raw).hexdigest()[:8]


def work_of(record):
    """The parameters that identify a timing of the grid or of drawing; None for others, whose runs are all kept."""
    names = ("table", "backend", "method", "draw", "work", "place", "n", "order")
    if record.parameters.get("table") not in ("grid", "draw"):
        return None
    scene = record.scene
    return (*(record.parameters.get(name) for name in names), scene["name"], scene.get("packing_fraction"))


def latest(records):
    """The latest record of each work; of the grid only those of sweeps if there is one."""
    swept = any(record.swept for record in records)
    records = [record for record in records
               if record.swept or not (swept and record.parameters.get("table") == "grid")]
    runs = {}
    for record in records:
        run = (record.swept, record.date, record.source)
        runs[work_of(record)] = max(runs.get(work_of(record), (False, "", "")), run)
    return [record for record in records if work_of(record) is None or runs[work_of(record)][2] == record.source]


class Machine:
    """One folder of recorded runs; a whole one has that of `spherepair compare`, another at least a sweep."""

    def __init__(self, folder, name=None, whole=True):
        self.folder = Path(folder)
        self.name = name or self.folder.name
        self.records, self.sources = [], {}
        self.used = {}  # records that were selected since it was last cleared, by their id()
        self.lost = 0  # timings whose interval reaches zero: on a busy machine noise is greater than they are
        self.notes = {}  # figure or table -> what its source line says of stale records
        self.runs = {}  # figure or table -> the ids of its sources
        for name, runs in sources_in(self.folder):
            self._read(name, [files for files in runs if files])
        self.records = latest(self.records)
        if whole and "results.json" not in self.sources:
            raise Missing(f"{self.folder} holds no results.json of `spherepair compare`")
        self.main = self.sources.get("results.json") or self.source("sweep")
        self.id = self.main["id"]

    @property
    def ids(self):
        return {name: source["id"] for name, source in self.sources.items()}

    def _read(self, name, runs):
        raws = [[path.read_bytes() for path in files] for files in runs]
        roots = [[json.loads(ids.today(raw.decode()), object_hook=batches.fitted) for raw in of_run] for of_run in raws]
        flat = [root for of_run in roots for root in of_run]
        if not flat or not all(isinstance(root, dict) for root in flat):
            return
        if name in self.sources:
            raise Missing(f"{self.folder} has {name} and a folder of the same records: remove the older one")
        source = f"{self.name}:{digest(b''.join(raw for of_run in raws for raw in of_run))}"
        processes = [spread.joined(of_run) for of_run in roots]
        root = processes[0] if len(processes) == 1 else spread.merged(processes)
        recorded = tuple(root.get("context", {}).get("sources") for root in flat)
        self.sources[name] = {**root, "id": source, "recorded": recorded, "contexts": [root.get("context") for root in flat],
                              "hosts": list(dict.fromkeys(map(host_of, flat)))}
        for part in flat if len(processes) == 1 else [root]:
            date = part.get("context", {}).get("date", "")
            own = {"table": table for start, table in TABLES.items() if name.startswith(start)}
            rows = [Record(row | own, *summary(row), source, date, name.startswith("sweep"), recorded)
                    for row in formats.rows_of(part)]
            self.records += (measured := [record for record in rows if record.low > 0])
            self.lost += len(rows) - len(measured)

    def select(self, **wanted):
        """All records with these parameters, smallest n first; `scene` is the scene's name."""
        found = [record for record in self.records if record.matches(wanted)]
        self.used.update((id(record), record) for record in found)
        return sorted(found, key=lambda record: record.parameters.get("n", 0))

    def need(self, **wanted):
        found = self.select(**wanted)
        if not found:
            raise Missing(f"{self.name} has no record of {text_of(wanted)}")
        return found

    def one(self, **wanted):
        found = self.need(**wanted)
        if len(found) > 1:
            raise Missing(f"{self.name} has {len(found)} records of {text_of(wanted)}; one was expected")
        return found[0]

    def note_on(self, name, line=""):
        """Keeps what is to be said of the records that were used since `used` was cleared; without any, of those of the
        runs that the line names."""
        rows = [({"backend": record.parameters.get("backend"), "draw": record.parameters.get("draw"),
                  "stages": record.parameters.get("device_stages_ms")}, digests)
                for record in self.used.values() for digests in record.recorded]
        self.notes[name] = sources.note(rows or [
            (row, digests) for root in self.sources.values() if root["id"] in line
            for row in sources.timings(root) for digests in root.get("recorded", ())])
        self.used.clear()
        return self.notes[name]

    def source(self, name):
        if name not in self.sources:
            raise Missing(f"{self.name} has no {name}: paper/record makes it")
        return self.sources[name]

    def backend(self, name):
        for backend in self.main["backends"]:
            if backend["name"] == name and backend["open"]:
                return backend
        raise Missing(f"{self.name} was run without {name}")

    def has(self, name):
        return any(backend["name"] == name and backend["open"] for backend in self.main["backends"])

    def seen(self, field):
        """The values that nvidia-smi reported around every table, each once."""
        gpus = [gpu for moment in self.main["clocks"] for gpu in moment["gpus"] or []]
        return ", ".join(dict.fromkeys(gpu[field] for gpu in gpus))

    @property
    def threads(self):
        """Of the CPU's backend: the cores that the process was given."""
        host = self.main["context"]["machine"]
        cpu = self.backend("cpu")["details"] if self.has("cpu") else {}
        return int(cpu.get("threads", host["hardware_threads"]))

    @property
    def driver(self):
        return self.seen("driver_version")

    @property
    def software(self):
        """GLSL runs on the CPU, so its times say nothing about a GPU."""
        return self.has("opengl") and self.backend("opengl")["software"]

    @property
    def short(self):
        """Device and run, for captions."""
        name = "cuda" if self.has("cuda") else "opengl" if self.has("opengl") else "cpu"
        return f"{self.backend(name)['device']}, run {self.id}"

    @property
    def gpu(self):
        """The device that the times are of, and its driver."""
        if self.has("cuda"):
            return f"{self.backend('cuda')['device']}, driver {self.driver}"
        return self.backend("opengl")["device"] if self.has("opengl") else ""

    def ids_in(self, text):
        """The ids of sources that a text names."""
        return [root["id"] for root in self.sources.values() if root["id"] in text]

    def title_of(self, ids):
        """One line with the device, the hosts on which these sources were recorded, and their ids."""
        hosts = dict.fromkeys(host for root in self.sources.values() if root["id"] in ids for host in root.get("hosts", ()))
        return "; ".join(filter(None, (self.gpu, f"CPU: {' and '.join(hosts)}" if hosts else "", f"run {', '.join(ids)}")))

    @property
    def title(self):
        return self.title_of([self.id])  # with the hardware and the main run


def named(machine, records):
    """The line under a figure of these records: the device, the hosts and the runs."""
    return machine.title_of(list(dict.fromkeys(record.source for record in records)))


def original_paper():
    """The original paper's printed times, row by row."""
    return json.loads((DATA / "original-paper.json").read_text())


def recorded_code():
    """Lines and compile times of the kernels, from count_code.py."""
    path = DATA / "code.json"
    if not path.exists():
        raise Missing(f"{path} is not there: paper/count_code.py writes it")
    return {**json.loads(ids.today(path.read_text())), "id": f"code:{digest(path.read_bytes())}"}


def peers():
    """Times of other systems on the same centres."""
    path = DATA / "peers.json"
    return {**json.loads(ids.today(path.read_text())), "id": f"peers:{digest(path.read_bytes())}"}
