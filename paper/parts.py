# SPDX-License-Identifier: MIT
"""The parts of a machine's recording: what each runs, what it leaves, and about how long it takes.

In a command {out} is the folder for its output, and in a file's name {process} the number of the process. Minutes are
estimates, of one process. Several processes are for the times by which the paper compares the APIs; intervals are over them.
"""
from dataclasses import dataclass, field, replace

from paper.tools import path_of

BACKENDS = ("cpu", "opengl", "cuda")
MOST_MINUTES = 8
SEVERAL = 5  # processes: of four a t-interval is 1.3 times as wide, of three twice
GIB = 2**30
TIMES = "table1,methods,overhead,exactness,scale,step,grid"  # of the APIs, compared over several processes
TABLES = f"{TIMES},counts,peak_rates,equality"
DECADES = "64,1024,16384,65536,262144,1000000,10000000"


@dataclass(frozen=True)
class Part:
    name: str
    minutes: int
    backends: tuple  # that it needs, in hardware but for the CPU's
    words: str  # of the command line
    files: dict  # in the output folder -> in the machine's folder; "." is the whole folder
    processes: int = 1
    again: str = ""  # the command line of those behind the first, where it is another
    memory: int = 0  # bytes that the GPU needs
    tests: bool = False  # runs the tests, not the program
    script: str = ""  # of this folder, which runs the program
    tools: tuple = ()  # of NVIDIA's, that the script needs
    environment: dict = field(default_factory=dict)
    alone: bool = False  # short steps or times of the CPU, which another recording on the same host would make longer


def study(name, minutes, backends, words, file, again="", **more):
    """A subcommand that leaves one JSON file in the folder that --results names."""
    words, again = (f"{line} --results {{out}}" if line else "" for line in (f"{words} --backends {backends}", again))
    return Part(name, minutes, tuple(backends.split(",")), words, {file: f"{name}/{{process}}.json"}, again=again, **more)


def sweep(name, minutes, backends, words, **more):
    words = f"sweep {words} --backends {backends} --results {{out}}/sweep"
    return Part(name, minutes, tuple(backends.split(",")), words, {"sweep": f"{name}/{{process}}"}, **more)


UNCACHED = {"SPHEREPAIR_CACHE": "", "__GL_SHADER_DISK_CACHE": "0", "MESA_SHADER_CACHE_DISABLE": "1"}


def compiling(backends):
    return Part("compile", 1, backends, "devices --compile --json {out}/compile.json", {"compile.json": "compile.json"}, environment=UNCACHED)


def first_use(backend):
    """In a process of its own, without the driver's cache of kernels."""
    name = f"first_use_{backend}"
    return Part(name, 1, (backend,), f"devices --first-use --backends {backend} --json {{out}}/{name}.json", {f"{name}.json": f"{name}.json"},
                environment=UNCACHED, alone=True)


def scripted(name, minutes, backends, file, *tools):
    return Part(name, minutes, backends, "{out}", {file: file}, script=name, tools=tools)


def testing(name, minutes, backends, filtered, files, **environment):
    return Part(name, minutes, backends, f"--gtest_filter={filtered}", files, tests=True,
                environment={"SPHEREPAIR_RECORD": "{out}", **environment})


def catalogue(backends, minutes, **environment):
    """The stress catalogue in two parts; row 29, in the second, also leaves the hashes of the states."""
    yield testing("stress-0-1", minutes[0], backends, "*Row0*:*Row1*", {"stress.json": "stress/rows-0-1.json"}, **environment)
    yield testing("stress-2-3", minutes[1], backends, "*Row2*:*Row3*",
                  {"stress.json": "stress/rows-2-3.json", "state_hashes.json": "state_hashes.json"}, **environment)


def test_shards(name, minutes, backends, filtered, shards, **environment):
    for k in range(shards):
        yield testing(f"{name}-{k + 1}", minutes, backends, filtered, {"output.txt": f"tests/{name.removeprefix('tests-')}-{k + 1}.txt"},
                      GTEST_TOTAL_SHARDS=str(shards), GTEST_SHARD_INDEX=str(k), REQUIRE_BACKENDS=",".join(backends), **environment)


def suite(minutes, minutes_of_a_half):
    """All tests: those of each backend by the end of their names, and the others in two halves. Shards of all tests would hold
    other backends whenever a test is added."""
    for backend, of_part in zip(BACKENDS, minutes):
        yield testing(f"tests-{backend}", of_part, BACKENDS, f"*/{backend}", {"output.txt": f"tests/{backend}.txt"},
                      REQUIRE_BACKENDS=",".join(BACKENDS))
    yield from test_shards("tests-rest", minutes_of_a_half, BACKENDS, "-" + ":".join(f"*/{name}" for name in BACKENDS), 2)


def in_hardware(part):
    if part.tests or part.script or "opengl" not in part.backends:
        return part
    words, again = (line and f"{line} --require-hardware" for line in (part.words, part.again))
    return replace(part, words=words, again=again)


GPU = tuple(map(in_hardware, (
    study("results", 4, "cpu,opengl,cuda", f"compare --scenes random,uniform --steps 2 --rounds 7 --tables {TABLES}", "results.json",
          again=f"compare --scenes random,uniform --steps 2 --rounds 7 --tables {TIMES} --backends opengl,cuda",
          processes=SEVERAL, alone=True),
    study("frame_rates", 2, "cpu,opengl,cuda", "compare --scenes random --steps 2 --rounds 7 --blocks 128 "
          "--tables frame_rates,arrangements --n 64,256,1024,4096,16384", "results.json", alone=True),
    sweep("sweep", 4, "opengl,vulkan,cuda", f"--n {DECADES} --rounds 11", processes=SEVERAL, alone=True),
    sweep("sweep_1e8", 1, "opengl,cuda", "--methods collide_grid --n 100000000 --packing-fractions 0.3 --rounds 11",
          memory=16 * GIB),
    sweep("sweep_core", 1, "opengl-core,opengl,cuda", "--methods collide_grid --n 1000000,10000000 --packing-fractions 0.3 --rounds 7",
          alone=True),
    sweep("sweep_core_1e8", 2, "opengl-core,opengl,cuda", "--methods collide_grid --n 100000000 --packing-fractions 0.3 --rounds 7",
          memory=16 * GIB),
    sweep("sweep_largest", 3, "cuda", "--methods collide_grid --n 1000000000 --packing-fractions 0.3 --rounds 11",
          memory=120 * GIB),
    sweep("sweep_tensor", 1, "cuda", "--methods collide_triangle,collide_tensor --n 4096,16384,65536,262144,1048576 "
          "--packing-fractions 0.3 --orders cold --rounds 11"),
    sweep("sweep_spirv", 1, "opengl-spirv,opengl-core,opengl", "--methods collide_triangle,collide_grid --n 65536 --packing-fractions 0.3 "
          "--orders cold --rounds 7", alone=True),
    *(first_use(backend) for backend in ("opengl", "vulkan", "cuda")),
    sweep("sweep_cpu", 2, "cpu", f"--n {DECADES} --rounds 11", alone=True),
    study("crossover", 7, "opengl,vulkan,cuda", "crossover", "crossover.json", processes=SEVERAL, alone=True),
    study("crossover_cpu", 2, "cpu", "crossover", "crossover.json", alone=True),
    study("ablate", 6, "opengl,cuda", "ablate --n 16384,1000000", "ablate.json", alone=True),
    study("ablate_extensions", 1, "opengl", "ablate --names large_pages,subgroups,texture_table --n 1000000,10000000 --rounds 7",
          "ablate.json", alone=True),
    study("contacts_errors", 3, "opengl,cuda", "contacts --measure errors,rates", "contacts.json"),
    study("contacts_steps", 3, "opengl,vulkan,cuda", "contacts --measure steps", "contacts.json"),
    study("contacts_1e8", 7, "opengl,cuda", "contacts --measure steps --n 100000000", "contacts.json", memory=40 * GIB),
    study("contacts_rest", 1, "opengl,cuda", "contacts --measure rest --rounds 6", "contacts.json"),
    study("contacts_rest_1e7", 7, "opengl,cuda", "contacts --measure rest --n 10000000 --rest-layers 150 "
          "--drag-steps 0.001:32000,0.1:2000 --rounds 6", "contacts.json", memory=16 * GIB),
    study("launches", 2, "opengl,vulkan,cuda", "launches --rounds 7", "launches.json", processes=SEVERAL, alone=True),
    study("energy_all_pairs", 5, "opengl,cuda", "energy --works all_pairs --windows 5 --seconds 10", "energy.json"),
    study("energy_grid", 5, "opengl,cuda", "energy --works warm,cold --n 10000000 --windows 5 --seconds 10", "energy.json"),
    study("frames", 3, "opengl,vulkan,cuda", "frames --draws compute --n 16384,1000000,10000000 --works frame,lit,loop",
          "frames.json"),
    study("frames_pipeline", 1, "opengl", "frames --draws mesh_each,mesh,points,impostor --places outside --works frame "
          "--n 16384,1000000,10000000 --most mesh_each:16384,mesh:1000000", "frames.json"),
    study("frames_1e8", 3, "opengl,cuda", "frames --draws compute --n 100000000 --works frame,loop", "frames.json",
          memory=16 * GIB),
    study("frames_1e9", 3, "cuda", "frames --draws compute --n 1000000000 --works frame", "frames.json",
          memory=120 * GIB),
    study("frames_transfer", 1, "vulkan,cuda", "frames --transfer --draws compute,points --places outside --works frame "
          "--n 16384,1000000", "frames.json"),
    study("frames_transfer_1e8", 5, "cuda", "frames --transfer --draws compute,points --places outside --works frame "
          "--n 100000000", "frames.json", memory=32 * GIB),
    study("precision_float32", 6, "opengl,cuda", "precision --precisions float32 --steps 4,6,8,10 --rounds 11",
          "precision.json"),
    *(study(f"precision_{precision}_{name}", minutes, "opengl,cuda", f"precision --precisions {precision} --motions {methods} "
            "--steps 4,6,8,10 --rounds 11", "precision.json")
      for precision, of_impacts in (("compensated", 7), ("float64", 6))
      for name, minutes, methods in (("steps", 4, "euler,symplectic,paper,paper-clamp"),
                                     ("impacts", of_impacts, "impact-linear,impact,anchored"))),
    study("precision_cpu", 4, "cpu", "precision --steps 4,6,8,10 --rounds 11", "precision.json", alone=True),
    study("precision_1e8", 5, "opengl,cuda", "precision --motions paper,anchored --precisions float32 --n 100000000 "
          "--steps 5 --rounds 11", "precision.json", memory=16 * GIB),
    study("precision_core", 1, "opengl-core,opengl,cuda", "precision --motions paper,anchored --precisions float32 --n 1000000 "
          "--steps 5 --rounds 7", "precision.json", alone=True),
    study("precision_core_1e8", 4, "opengl-core,opengl,cuda", "precision --motions paper --precisions float32 --n 100000000 "
          "--steps 5 --rounds 7", "precision.json", memory=16 * GIB),
    study("sets", 4, "cpu,opengl,cuda", "sets --motions paper,impact,anchored", "sets.json", alone=True),
    compiling(("cpu", "opengl", "vulkan", "cuda")),
    scripted("listings", 1, ("opengl", "cuda"), "listings", "cuobjdump", "nvdisasm"),
    scripted("counters", 2, ("cuda",), "counters.json", "ncu"),
    *catalogue(("cpu", "opengl", "cuda"), (2, 5), STRESS="full", REQUIRE_BACKENDS="cpu,opengl,cuda"),
    *suite((2, 5, 4), 5),  # with the catalogue in its short form
    testing("contacts_long", 7, BACKENDS, "*LongContacts*", {"output.txt": "tests/contacts_long.txt"},
            STRESS="full", REQUIRE_BACKENDS=",".join(BACKENDS)),
    *test_shards("contacts_gas", 2, BACKENDS, "*ContactPhysics*", 3, STRESS="full"),
)))

SOFTWARE = tuple(replace(part, alone=not part.tests) for part in (
    study("results", 4, "cpu,opengl", f"compare --tables {TABLES}", "results.json", processes=SEVERAL),
    study("frame_rates", 2, "cpu,opengl", "compare --scenes random --steps 2 --blocks 128 "
          "--tables frame_rates,arrangements --n 64,256,1024,4096,8192", "results.json"),
    study("crossover", 2, "cpu", "crossover --most-ms 60", "crossover.json"),
    study("crossover_glsl", 2, "opengl", "crossover", "crossover.json"),
    study("cpu_grid", 1, "cpu", "ablate --names pair_list --n 1000000,10000000", "ablate.json"),
    study("contacts_cpu", 5, "cpu", "contacts --threads 2 --measure steps --n 1000000 --averaged 1000 --rounds 6",
          "contacts.json"),
    study("precision", 2, "cpu,opengl", "precision --threads 1 --rounds 11", "precision.json"),
    *catalogue(("cpu", "opengl"), (3, 3)),
))


@dataclass(frozen=True)
class Run:
    """A part in one process."""
    part: Part
    process: int

    @property
    def name(self):
        return f"{self.part.name}-{self.process}" if numbered(self.part) else self.part.name

    def targets(self):
        """file of the output folder -> file of the machine's folder"""
        return {file: target.format(process=self.process) for file, target in self.part.files.items()}

    def command(self, out, gpu=""):
        """(words, variables of the environment)"""
        variables = dict(self.part.environment)
        if gpu and set(self.part.backends) & {"opengl", "cuda"}:
            variables["CUDA_VISIBLE_DEVICES"] = gpu
        words = self.part.again if self.process > 1 and self.part.again else self.part.words
        return ([word.format(out=out) for word in words.split()],
                {name: value.format(out=out) for name, value in variables.items()})


def numbered(part):
    """Whether a process's number is in the names of its files, which spread.py reads as those of processes."""
    return any("{process}" in target for target in part.files.values())


def runs(parts, several=SEVERAL):
    """Every part once, then those of several processes again: what is interrupted can be read."""
    first = [Run(part, 1) for part in parts]
    return first + [Run(part, process) for process in range(2, several + 1) for part in parts if part.processes > 1]


def done(run, folder):
    return all((folder / target).exists() for target in run.targets().values())


def missing_needs(part, backends):
    """Why this machine cannot run a part, or nothing; `backends` is the list of `spherepair devices`."""
    opened = {backend["name"]: backend for backend in backends if backend.get("open")}
    if "cuda" in opened and opened.get("opengl", {}).get("software"):
        del opened["opengl"]  # records of a GPU are of its own OpenGL
    absent = [name for name in part.backends if name.removesuffix("-core").removesuffix("-spirv") not in opened]
    if absent:
        return f"needs {', '.join(absent)}"
    unfound = [name for name in part.tools if not path_of(name)]
    if unfound:
        return f"needs {', '.join(unfound)} of the CUDA toolkit"
    memory = opened.get("cuda", {}).get("details", {}).get("memory bytes")
    if part.memory and memory and int(memory) < part.memory:
        return f"needs {part.memory // GIB} GiB on the GPU, which has {int(memory) // GIB}"
    return ""


def of_machine(backends):
    """The parts of a machine with an NVIDIA GPU, or of one without."""
    return GPU if any(backend["name"] == "cuda" and backend.get("open") for backend in backends) else SOFTWARE
