# SPDX-License-Identifier: MIT
"""Rules on what compilers make of kernels: glslang's SPIR-V, as Vulkan gets it, nvcc's PTX, flags.

Each takes (root, build) and returns (complaints, what was checked)."""

import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import tempfile

import lint_kernels
from lint_sources import Skip

STATE_FEEDING = ("move", "bounce", "evaluate_positions", "contact_pairs", "leapfrog")  # kernels whose results are the next step's input: every bit counts, so nothing is fused
WITH_SEARCH = ("persistent_steps",)  # feeds state and searches: the filter's own fused multiply-adds are its only ones
CHOICES = "EQUAL_RADII", "DENSE", "BUNDLES", "BY_CELLS", "LONG_ROWS", "FROM_TILES"  # of kernels that feed no state
METHODS, PRECISIONS = range(6), ("float", "Two", "double")  # of layout.h; bounce and evaluate_positions are of one method
EXACT_FUNCTIONS = ("PackDouble2x32", "UnpackDouble2x32", "FAbs", "FMin", "FMax", "NMin", "NMax", "UMin", "UMax", "SMin",
                   "SMax", "FindUMsb", "FindSMsb", "FindILsb")
ROUNDED = re.compile(r"(%\w+) = (OpF(?:Add|Sub|Mul|Div|Rem|Mod)|Op(?:Vector|Matrix)Times\w+|OpDot|OpOuterProduct) ")
LOOSE_PTX = re.compile(r"^\s*((?:fma|mad)\.(?:\w+\.)*f(?:32|64)|(?:add|sub|mul)\.(?:ftz\.|sat\.)*f(?:32|64)|"
                       r"\w+\.(?:approx|full)\.(?:\w+\.)*f(?:32|64))\b.*", re.M)
MAY_CONTRACT = ("common/cpu/search/cpu_simd.cpp", "tests/")  # a filter whose bound covers both roundings; negative controls
LOOSE_FLAGS = ("-ffast-math", "-Ofast", "--use_fast_math", "-use_fast_math", "--ftz=true", "-ffp-contract=fast")


def with_defines(text, *defines):
    """As the driver gets it: the definitions follow the #version line."""
    extensions = {"ATOMICS_64": "GL_NV_shader_atomic_int64"}
    lines = "".join(f"#extension {extensions[define]} : require\n" for define in defines if define in extensions)
    lines += "".join(f"#define {define}\n" for define in defines)
    return re.sub(r"(#version .*\n)", lambda match: match[1] + lines, text, count=1)


def disassembled(texts, build):
    """SPIR-V assembly of each compute shader, as the program compiles them for Vulkan, or what was wrong with it."""
    compiler = build / "tests/lint/compile_shaders"
    if not compiler.exists():
        raise Skip("this build has no Vulkan, whose SPIR-V is looked at")
    if not shutil.which("spirv-dis"):
        raise Skip("spirv-dis is not installed (package spirv-tools)")
    with tempfile.TemporaryDirectory() as folder:
        for k, text in enumerate(texts):
            pathlib.Path(folder, f"{k}.comp").write_text(text)
        subprocess.run([compiler, folder], check=True)
        for k in range(len(texts)):
            binary, wrong = pathlib.Path(folder, f"{k}.spv"), pathlib.Path(folder, f"{k}.txt")
            yield (ValueError(wrong.read_text()) if wrong.exists() else
                   subprocess.run(["spirv-dis", binary], capture_output=True, text=True, check=True).stdout)


def variants(stem, text):
    """The definitions of every program that is made from a shader."""
    if stem not in STATE_FEEDING:
        plain = ("BLOCK 256", "LISTED true", *(f"{word} false" for word in CHOICES), "INDICES 4u")
        equal = tuple(define.replace("false", "true") if define.startswith(("EQUAL_RADII", "DENSE")) else define for define in plain[:-1])
        equal += ("INDICES 2u", *(word for word in ("FOLDED", "ATOMICS_64") if word in text))  # independent of each other
        chosen = [tuple(define.replace(f"{word} false", f"{word} true") for define in plain)
                  for word in CHOICES if word in text and word not in ("EQUAL_RADII", "DENSE")]
        texture = [(*plain, "TEXTURE_TABLE"), (*plain, "TEXTURE_TABLE", "WINDOWS")] if "TEXTURE_TABLE" in text else []
        return [plain, equal, *chosen, *texture[:2 if "WINDOWS" in text else 1]]
    if stem in ("contact_pairs", "leapfrog"):
        return [("BLOCK 256", "INDICES 0u", "METHOD 7u", "PRECISION 3", "Real int64_t")]
    methods = METHODS if stem == "move" else (6,)
    return [("BLOCK 256", "INDICES 0u", f"METHOD {method}u", f"PRECISION {precision}", f"Real {real}")
            for method in methods for precision, real in enumerate(PRECISIONS)]


def spirv_complaints(assembly, may_fuse):
    exact = set(re.findall(r"OpDecorate (%\w+) NoContraction", assembly))
    complaints = []
    for result, operation in ROUNDED.findall(assembly):
        if result not in exact:
            complaints.append(f"{operation} {result} may be contracted: compute it into an EXACT local")
    for function in re.findall(r"= OpExtInst %\w+ %\w+ (\w+)", assembly):
        if function == "Fma" and not may_fuse:
            complaints.append("Fma in a kernel that feeds state: it is fused on one driver and not on another")
        elif function != "Fma" and function not in EXACT_FUNCTIONS:
            complaints.append(f"{function} is not exact on every driver")
    return complaints


def shaders(root, build):
    flattened = sorted((build / "flattened").glob("*.comp"))
    if not flattened:
        raise Skip("no flattened shaders: the build has no GLSL")
    missing = {p.stem for p in (root / "shaders").rglob("*.comp")} - {p.stem for p in flattened}
    complaints = [f"{stem}.comp: is not built: add it to common/device/kernel_list.h" for stem in sorted(missing)]
    programs = [(path, defines) for path in flattened for defines in variants(path.stem, path.read_text())]
    used = {path.stem: [] for path in flattened}
    texts = [with_defines(path.read_text(), *defines) for path, defines in programs]
    for (path, defines), assembly in zip(programs, disassembled(texts, build)):
        found = [str(assembly)]
        if not isinstance(assembly, ValueError):
            found = spirv_complaints(assembly, may_fuse=path.stem not in STATE_FEEDING)
            used[path.stem].append(lint_kernels.used_slots(assembly))
        complaints += [f"{path.name} ({', '.join(defines)}): {complaint}" for complaint in found]
    for stem, found in used.items():
        complaints += lint_kernels.complaints(root, stem, found)
    return complaints, f"{len(flattened)} shaders in {len(programs)} variants"


def ptx_complaints(text, with_search=False):
    """Without .rn the assembler behind PTX may still fuse, so every operation must name its rounding."""
    return [f"{match[0].strip()}: is fused or may be" for match in LOOSE_PTX.finditer(text)
            if not (with_search and match[1] == "fma.rn.f32")]


def compile_commands(build):
    path = build / "compile_commands.json"
    if not path.exists():
        raise Skip(f"{path.name} is missing: configure with Ninja or Make")
    return json.loads(path.read_text())


def ptx_of(entry, *, without=(), architecture=90, **options):
    """PTX of one kernel with the flags that the build compiles it with; options of subprocess.run."""
    words, kept, skip = shlex.split(entry["command"]), [], False
    for word in words:
        if skip or word in ("-c", "-MD") or re.match(r"-{1,2}(generate-code|gencode|arch)\b", word) or word in without:
            skip = False
        elif word in ("-o", "-MT", "-MF"):
            skip = True
        else:
            kept.append(word)
    with tempfile.TemporaryDirectory() as folder:
        output = os.path.join(folder, "kernel.ptx")
        subprocess.run([*kept, "-ptx", f"-arch=compute_{architecture}", "-o", output], cwd=entry["directory"], check=True, **options)
        return pathlib.Path(output).read_text()


def kernel_commands(root, build):
    stems = STATE_FEEDING + WITH_SEARCH
    wanted = {str(path): path.stem for path in (root / "cuda").rglob("*.cu") if path.stem in stems}
    found = {wanted[e["file"]]: e for e in compile_commands(build) if e["file"] in wanted}
    if not found:
        raise Skip("this build has no CUDA (no nvcc was found)")
    return found


def ptx(root, build):
    commands = kernel_commands(root, build)
    complaints = [f"{stem}.cu: is not built" for stem in STATE_FEEDING + WITH_SEARCH if stem not in commands]
    for stem, entry in commands.items():
        complaints += [f"{stem}.cu: {complaint}" for complaint in ptx_complaints(ptx_of(entry), stem in WITH_SEARCH)]
    return complaints, f"{len(commands)} kernels that feed state"


def warp_functions(root, source):
    """Whether a kernel, or a header of its own folder, calls one of CUDA's functions on warps: not all GPUs have all."""
    text = source.read_text()
    headers = [root / name for name in re.findall(r'#include "(cuda/[\w/]+\.cuh)"', text)]
    return bool(re.search(r"\b__\w+_sync\(", text)) or any(warp_functions(root, header) for header in headers)


def compiles_for(entry, architecture, **options):
    try:
        return bool(ptx_of(entry, architecture=architecture, **options))
    except subprocess.CalledProcessError:
        return False


def oldest(root, build):
    """The oldest GPU that a build is for unless told otherwise compiles what calls functions on warps."""
    architecture = int(re.search(r"set\(CMAKE_CUDA_ARCHITECTURES (\d+)-virtual", (root / "CMakeLists.txt").read_text())[1])
    kernel_commands(root, build)
    entries = [e for e in compile_commands(build) if e["file"].startswith(str(root / "cuda")) and e["file"].endswith(".cu")]
    chosen = [e for e in entries if warp_functions(root, pathlib.Path(e["file"]))]
    complaints = []
    for entry in chosen:
        if not compiles_for(entry, architecture):
            complaints.append(f"{os.path.relpath(entry['file'], root)}: does not compile for compute_{architecture}, see above")
    return complaints, f"{len(chosen)} kernels for compute_{architecture}"


def flag_complaints(entry):
    words = shlex.split(entry["command"])
    complaints = [f"is compiled with {flag}" for flag in LOOSE_FLAGS if flag in words]
    if not any("-ffp-contract=off" in word for word in words):
        complaints.append("is compiled without -ffp-contract=off")
    if entry["file"].endswith(".cu") and "--fmad=false" not in words:
        complaints.append("is compiled without --fmad=false")
    return complaints


def flags(root, build):
    entries = [e for e in compile_commands(build) if e["file"].startswith((f"{root}/", f"{build}/"))]
    complaints = []
    for entry in entries:
        name = os.path.relpath(entry["file"], root)
        if not name.startswith(MAY_CONTRACT):
            complaints += [f"{name}: {complaint}" for complaint in flag_complaints(entry)]
    return complaints, f"{len(entries)} compilations"
