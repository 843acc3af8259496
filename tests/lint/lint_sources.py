# SPDX-License-Identifier: MIT
"""Rules on the text of the sources. Each takes (root, build) and returns (complaints, what was checked)."""

import importlib.util
import re
import shutil
import subprocess
import sys

MAX_LINES = 250
MAX_FUNCTION = 60  # lines, of host code
CLANG_FORMAT = 14  # other versions lay out some lines differently
CODE = (".h", ".cpp", ".cu", ".cuh", ".comp", ".glsl")
FOLDERS = ("common", "shaders", "glsl", "vulkan", "cuda", "interop", "api", "include", "bench", "tests", "paper",
           "examples", "python")

# What has no one meaning on all compilers, see rule 1 of the design: their rounding differs even under `precise`.
FORBIDDEN = re.compile(r"(?<![.\w])(dot|length|distance|normalize|mix|inversesqrt|sqrt|floor|fmaf?|exp|pow)\s*\(")
FOREIGN = re.compile(r'^\s*#\s*include\s*[<"]((?:vulkan|glslang|GL|GLES\w*|EGL|epoxy|cuda|thrust|cub)[/_.\w]*)', re.M)


class Skip(Exception):
    """A rule cannot be checked here; the text says why."""


def sources(root, suffixes=CODE + (".py", ".cmake")):
    found = []
    for folder in FOLDERS:
        found += [p for p in sorted((root / folder).rglob("*")) if p.suffix in suffixes and p.is_file()]
        found += sorted((root / folder).rglob("CMakeLists.txt")) if ".cmake" in suffixes else []
    return found


def strip_comments(text):
    return re.sub(r"//[^\n]*|/\*.*?\*/", " ", text, flags=re.S)


def files(root, build):
    names = ("check", "reproduce", "paper/record", "paper/listings", "paper/counters", "CMakeLists.txt", ".ci/run",
             ".ci/sanitize", ".ci/setup.sh")
    scripts = [root / name for name in names]
    checked = sources(root) + [p for p in scripts if p.exists()]
    complaints = []
    for path in checked:
        lines = path.read_text().splitlines()
        name = path.relative_to(root)
        if len(lines) > MAX_LINES:
            complaints.append(f"{name}: {len(lines)} lines, more than {MAX_LINES}: split it")
        if lines and not any("SPDX-License-Identifier: MIT" in line for line in lines[:2]):
            complaints.append(f"{name}: has no SPDX-License-Identifier in its first two lines")
    return complaints, f"{len(checked)} files"


def shared_headers(root):
    return sorted((root / "common/shared").rglob("*.h"))


def conditionals(text):
    """Preprocessor conditions but for the include guard."""
    lines = re.findall(r"^\s*#\s*((?:if|ifdef|ifndef|elif|else)\b.*)", strip_comments(text), re.M)
    guard = re.search(r"^#ifndef (\w+)\n#define \1$", text, re.M)
    if guard and lines and lines[0] == f"ifndef {guard[1]}":
        lines = lines[1:]
    return [line.strip() for line in lines]


def headers(root, build):
    shared = shared_headers(root)
    complaints = []
    allowed = {"layout.h": ["ifndef GL_core_profile"]}  # its static_asserts
    for path in shared:
        found = conditionals(path.read_text())
        if path.name != "portable.h" and found != allowed.get(path.name, []) and found:
            complaints.append(f"{path.relative_to(root)}: #{found[0]}: conditions belong into portable.h")
    for path in sorted((root / "common").rglob("*.h")):
        for include in FOREIGN.findall(path.read_text()):
            complaints.append(f"{path.relative_to(root)}: includes {include}: no GL, CUDA or Thrust header in common/")
    if not shared:
        complaints.append("common/shared has no headers")
    return complaints, f"{len(shared)} shared headers"


def borders(root, build):
    """Only api/open.cpp asks what was built."""
    checked = sources(root, CODE)
    asking = [path.relative_to(root) for path in checked if "SPHEREPAIR_WITH_" in path.read_text()]
    complaints = [f"{name}: asks what was built; only api/open.cpp may" for name in asking if str(name) != "api/open.cpp"]
    return complaints, f"{len(checked)} files"


def builtins(root, build):
    shaders = [*sorted((root / "shaders").rglob("*.comp")), *sorted((root / "shaders").rglob("*.glsl"))]
    complaints = []
    for path in shaders + shared_headers(root):
        text = strip_comments(path.read_text())
        if path.name == "portable.h":
            text = re.sub(r"float multiply_add\(.*", "", text)
        for match in FORBIDDEN.finditer(text):
            complaints.append(f"{path.relative_to(root)}: {match[1]}() is not the same on all compilers")
    return complaints, f"{len(shaders)} shaders and their headers"


def clang_format():
    for name in (f"clang-format-{CLANG_FORMAT}", "clang-format"):
        if shutil.which(name):
            version = subprocess.run([name, "--version"], capture_output=True, text=True).stdout
            if f"version {CLANG_FORMAT}." in version:
                return name
    raise Skip(f"clang-format {CLANG_FORMAT} is not installed, and other versions lay lines out differently")


def formatting(root, build):
    tool = clang_format()
    checked = sources(root, CODE)
    command = [tool, "--dry-run", "-Werror", "--style=file", *map(str, checked)]
    result = subprocess.run(command, cwd=root, capture_output=True, text=True)
    first_places = {}
    for path, line in re.findall(r"^(.*?):(\d+):\d+: error: .*\[-Wclang-format", result.stderr, re.M):
        first_places.setdefault(path.replace(f"{root}/", ""), line)
    complaints = [f"{path}:{line}: run {tool} -i {path}" for path, line in first_places.items()]
    if result.returncode and not complaints:
        complaints = [result.stderr.strip()]
    return complaints, f"{len(checked)} files"


def function_lengths(text):
    """(number of the first line, lines) of every function: clang-format has braces where this looks for them."""
    lines = text.splitlines()
    for first, line in enumerate(lines):
        indent = re.match(r"( {0,2})(?!(?:namespace|class|struct|enum|union|extern|if|for|while|switch|else|do)\b)\S.*\{$", line)
        if not indent or "(" not in line and not re.search(r"\)[^;]*$", lines[first - 1]):
            continue
        close = next((k for k in range(first + 1, len(lines)) if re.match(indent[1] + r"\}", lines[k])), first)
        yield first + 1, close - first + 1


def functions(root, build):
    checked = [p for p in sources(root, (".h", ".cpp")) if p.relative_to(root).parts[0] not in ("shaders", "tests")]
    complaints = [f"{path.relative_to(root)}:{first}: a function of {length} lines, more than {MAX_FUNCTION}"
                  for path in checked for first, length in function_lengths(path.read_text()) if length > MAX_FUNCTION]
    return complaints, f"{len(checked)} files"


def mutants(root, build):
    """Every deliberate fault of tests/mutants names text that stands exactly once in its file, and suites."""
    spec = importlib.util.spec_from_file_location("mutant_list", root / "tests/mutants/mutant_list.py")
    module = importlib.util.module_from_spec(spec)
    sys.path.insert(0, str(root / "tests/mutants"))  # for what it imports
    spec.loader.exec_module(module)
    sys.path.pop(0)
    complaints = []
    entries = [suite for path in (root / "tests").rglob("test_*.cpp")
               for suite in re.findall(r"^(?:TEST|TEST_F|TEST_P|RC_GTEST_PROP|RC_GTEST_FIXTURE_PROP)\((\w+)", path.read_text(), re.M)]
    for names in re.findall(r"foreach\(name ([^)]*)\)", (root / "tests/lint/CMakeLists.txt").read_text()):
        entries += ["paper." + name for name in names.split()]
    for mutant in module.MUTANTS:
        for name in mutant["tests"]:
            if not any(entry.startswith(name.split(".Row")[0]) for entry in entries):
                complaints.append(f"tests/mutants/mutant_list.py: '{mutant['name']}' names {name}, with which no suite begins")
        path = root / mutant["file"]
        count = path.read_text().count(mutant["old"]) if path.is_file() else 0
        if count != 1:
            complaints.append(f"{mutant['file']}: the text of the mutant '{mutant['name']}' stands there {count} times")
    return complaints, f"{len(module.MUTANTS)} mutants"
