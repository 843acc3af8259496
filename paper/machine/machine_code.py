# SPDX-License-Identifier: MIT
"""The hot loops of the kernels as both compilers made them: CUDA's from the program, OpenGL's from what the driver
compiles and keeps. Groups of 128, equal radii, pairs counted and not listed."""
import json
import re
import shutil
import tempfile

from paper.machine import sass, shader_cache
from paper.recording import devices_of
from paper.tools import Failed, output_of, version_of

BLOCK = 128
KERNELS = {  # -> spheres of the run that compiles it, and what a loop has of these instructions for each pair that it tests
    "collide_tiled": (16384, "FSETP", 1),
    "collide_triangle": (16384, "FFMA", 3),
    "collide_grid": (1000000, "FSETP", 1),
}
CUDA_NAME = r"_ZN10spherepair\d+{kernel}ILi{block}ELb1ELb0E\w+"  # of a template's block, EQUAL_RADII and LISTED


def architecture_of(backends):
    """The architecture as nvdisasm names it, e.g. SM90; backends as `spherepair devices` lists them."""
    for backend in backends:
        if backend["name"] == "cuda" and backend.get("open"):
            return "SM" + backend["details"]["compute capability"].replace(".", "")
    raise Failed("the listings are of an NVIDIA GPU's code, and cuda is not open: see `spherepair devices`")


def disassembled(code, architecture):
    with tempfile.NamedTemporaryFile(suffix=".bin") as file:
        file.write(code)
        file.flush()
        return output_of("nvdisasm", "--binary", architecture, file.name)


def cuda_code(kernel, program, architecture):
    """(the function's name, its text, registers as compiled)"""
    chosen = ("--gpu-architecture", architecture.lower().replace("sm", "sm_"))
    usage = output_of("cuobjdump", *chosen, "--dump-resource-usage", program)
    pattern = CUDA_NAME.format(kernel=kernel, block=BLOCK)
    found = dict(re.findall(rf"Function ({pattern}):\s+REG:(\d+)", usage))
    if len(found) != 1:
        raise Failed(f"{program} has {len(found)} functions {pattern} for {architecture}: one is expected; build it with "
                     f"CUDA for this GPU")
    (name, registers), = found.items()
    return name, output_of("cuobjdump", *chosen, "--dump-sass", "--function", name, program), int(registers)


def glsl_code(kernel, program, architecture):
    """The same, of the program with the most float instructions in its hot loop: a run compiles others, too."""
    words = [program, "run", "--backend", "opengl", "--scene", "uniform", "--packing-fraction", "0.3", "--steps", "0",
             "--method", kernel, "--block", str(BLOCK), "--n", str(KERNELS[kernel][0])]
    texts = [(name, disassembled(code, architecture)) for name, code in shader_cache.compiled_by(words)]
    loops = [(sass.hot_loop(sass.parse(text)), name, text) for name, text in texts]
    if not any(loop for loop, _, _ in loops):
        raise Failed(f"none of {len(texts)} programs that OpenGL compiled for {kernel} has a loop with float instructions")
    _, name, text = max(loops, key=lambda found: sass.floats(found[0]) if found[0] else 0)
    return name, text, None


def listing_of(kernel, api, code):
    """(entry of the record, text of the loop)"""
    name, text, registers = code
    instructions = sass.parse(text)
    loop = sass.hot_loop(instructions)
    if not loop:
        raise Failed(f"{kernel} of {api}: no loop with float instructions in the disassembly of {name}, which begins\n"
                     + "\n".join(text.splitlines()[:12]))
    _, opcode, each = KERNELS[kernel]
    counts = loop.counts()
    pairs, rest = divmod(counts["by_opcode"].get(opcode, 0), each)
    known = pairs and not rest
    entry = {"kernel": kernel, "backend": api, "block": BLOCK, "name": name, "file": f"{kernel}-{api}.txt",
             "instructions_of_kernel": len(instructions), "registers": registers,
             "registers_named": sass.registers_named(instructions), "loop": counts, "pairs": pairs if known else None,
             "instructions_per_pair": counts["instructions"] / pairs if known else None}
    heading = (f"{kernel}, {api}, groups of {BLOCK}, equal radii: the hot loop. The shortest way round, marked |, has "
               f"{counts['instructions']} instructions" + (f" for {pairs} pairs" if known else "") + ".\n\n")
    return entry, heading + loop.listing()


def write_listings(folder, program):
    """FOLDER/listings with listings.json and a text of each kernel and API, whole or not at all. Returns the entries."""
    devices = devices_of(program)
    architecture = architecture_of(devices["backends"])
    made = [listing_of(kernel, api, code_of(kernel, program, architecture))
            for kernel in KERNELS for api, code_of in (("opengl", glsl_code), ("cuda", cuda_code))]
    record = {"format": "spherepair listings 1", "context": devices["context"], "backends": devices["backends"],
              "architecture": architecture, "tools": {name: version_of(name) for name in ("cuobjdump", "nvdisasm")},
              "listings": [entry for entry, _ in made]}
    target = folder / "listings"
    unfinished = folder / ".unfinished-listings"
    shutil.rmtree(unfinished, ignore_errors=True)
    unfinished.mkdir(parents=True)
    for entry, text in made:
        (unfinished / entry["file"]).write_text(text)
    (unfinished / "listings.json").write_text(json.dumps(record, indent=1) + "\n")
    shutil.rmtree(target, ignore_errors=True)
    unfinished.replace(target)
    return record["listings"]
