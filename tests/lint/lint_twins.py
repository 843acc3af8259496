# SPDX-License-Identifier: MIT
"""Twins: shaders/ROOM/NAME.comp and cuda/ROOM/NAME.cu, or NAME.glsl and NAME.cuh, are one program in two languages.

Both texts are brought into one form by the table below and cut into statements; these must then be the same, one after
the other. A statement that one language alone has carries a reason: `// CUDA only: why` on its line or on a line of its
own before it, or for several `// CUDA only from here: why` ... `// until here`; `// GLSL only` likewise. Variables in
shared memory and constants are compared as a set, since CUDA declares some of them in the kernel."""

import difflib
import re

PREFIX = {"GLSL": "shaders", "CUDA": "cuda"}
SUFFIXES = ((".comp", ".cu"), (".glsl", ".cuh"))
MARK = re.compile(r"//\s*(?:(GLSL|CUDA) only( from here)?(?::\s*(\S.*))?|(until here))")

# What is plumbing in one language: (pattern, what takes its place).
COMMON = (
    (r"^#ifndef (\w+)\n#define \1\b.*\n#endif", ""),  # a default
    (r"^\s*#\s*(?:include|version|pragma once|extension|define|undef)\b.*", ""),
    (r"^\s*#\s*(?:if|ifdef) (.*)", r"if (\1) {"),
    (r"^\s*#\s*else\b.*", "} else {"),
    (r"^\s*#\s*endif\b.*", "}"),
)
GLSL = (
    (r"\blayout\([^{;]*(?:\{[^}]*\}[^;]*)?;", ""),  # CUDA has the struct KernelBuffers
)
CUDA = (
    (r"namespace (?:spherepair )?\{", ""),
    (r"unsigned long long", "uint64_t"),
    (r"\}\s*\Z", ""),
    (r"^(?:template <[^;{]*?>\n)?Entry \w+\([^;{]*\) \{(?:.+\}$|\n(?:[ \n].*\n)*?\})", ""),  # for the host, to find kernels
    (r"\bstatic_assert\([^;]*\);", ""),
    (r"^constexpr uint BLOCK = \w+;", ""),  # a definition of the program in GLSL
    (r"(?:const )?\w+\* \w+ = (?:reinterpret|static)_cast<[^;]*>\(buf\.\w+\);", ""),  # declared so in the layout
    (r"Collider<[^;]*> collider\(p, buf\);", ""),
    (r"template <[^;{]*?>\n", ""),
    (r"__global__ void __launch_bounds__\(.*?\) \w+\([^)]*\)", "void main()"),
    (r"\b__device__ ", ""),
    (r"\binline ", ""),
    (r"__shared__", "shared"),
    (r"\bconstexpr (?=uint|float|int)", "const "),
    (r"\bif constexpr\b", "if"),
    (r"std::is_same_v<Real, float>", "PRECISION == PRECISION_FLOAT32"),
    (r"const (?:Params|KernelBuffers|View)& \w+(?:,\s*)?", ""),
    (r"(?:const )?Collider<[^>]*>& collider(?:,\s*)?", ""),
    (r"const (\w+)& ", r"\1 "),
    (r"\) const \{", ") {"),
    (r"\bcollider\.(?:buf\.)?", ""),
    (r"\bbuf\.", ""),
    (r"(?<=\()(?:(?:p|buf|v), )*(?:(?:p|buf|collider)(?=\))|collider, )?", ""),  # at the head of a call's arguments
    (r"(?<=\w)<(?:\w+(?:, )?)+>(?=[\[({;)% ])", ""),  # template arguments
    (r"\bsize_t\((.*?)\)", r"\1"),
    (r"\bsize_t\b", "uint"),
    (r"reinterpret_cast<\w+\*>\((\w+)\)", r"\1"),
    (r"VISIBLE_LOAD\(&(.*?\])\)", r"\1"),
    (r"(atomic\w+)\(&", r"\1("),
    (r"\b([a-zA-Z]\w*)\{([^{};]*)\}", r"\1(\2)"),  # vec4{...}
    (r"__syncthreads\(\)", "barrier()"),
    (r"threadIdx\.", "gl_LocalInvocationID."),
    (r"blockIdx\.", "gl_WorkGroupID."),
    (r"gridDim\.", "gl_NumWorkGroups."),
    (r"blockDim\.x", "BLOCK"),
)


def without_marked(text, language):
    """The text without comments and without what is marked for this language; and complaints about the marks."""
    kept, complaints, in_block, in_statement = [], [], False, False
    for number, line in enumerate(text.splitlines(), 1):
        mark, code = MARK.search(line), re.sub(r"//.*", "", line).rstrip()
        names, begins, reason, ends = mark.groups() if mark else (None, None, None, None)
        if names and (names != language or not reason):
            complaints.append(f"line {number}: the mark names the other language or gives no reason")
        if ends and not in_block:
            complaints.append(f"line {number}: `until here` without a beginning")
        in_statement = in_statement or bool(names and not begins)
        kept.append("" if in_block or in_statement else code)
        if code.strip():  # a statement may go on in the next line
            in_statement = in_statement and not re.search(r"[;{}]$|^\s*#", code)
        in_block = (in_block or bool(begins)) and not ends
    if in_block:
        complaints.append("`from here` without `until here`")
    return "\n".join(kept), complaints


def normalised(text, table):
    for pattern, replacement in table:
        text = re.sub(pattern, replacement, text, flags=re.M)
    return text


def statements(text, language):
    """(sorted declarations of shared memory and constants, all other statements)."""
    text = normalised(text, (GLSL if language == "GLSL" else CUDA) + COMMON)
    parts = [re.sub(r"\s+", " ", part).strip() for part in re.findall(r"[^;{}]+|[{}]", text)]
    parts = [re.sub(r"(?<=[(\[]) | (?=[)\]])", "", part) for part in parts if part]
    hoisted = [part for part in parts if re.match(r"(?:shared|const) ", part)]
    return sorted(hoisted), [part for part in parts if part not in hoisted]


def first_sentence(text):
    """Of the first comment after the SPDX line: how threads map to work."""
    comment = []
    for line in text.splitlines():
        if line.startswith("//") and "SPDX" not in line:
            comment.append(line.lstrip("/ ").rstrip())
        elif comment:
            break
    return re.split(r"(?<=\.)\s", " ".join(comment), maxsplit=1)[0]


def differences(shader, kernel):
    """Complaints about the bodies of two twins."""
    complaints, sides = [], []
    for text, language in ((shader, "GLSL"), (kernel, "CUDA")):
        kept, found = without_marked(text, language)
        complaints += [f"{language}, {complaint}" for complaint in found]
        sides.append(statements(kept, language))
    for left, right in zip(*sides):
        for operation, a, b, c, d in difflib.SequenceMatcher(None, left, right, autojunk=False).get_opcodes():
            if operation != "equal":
                complaints.append(f"  GLSL: {'; '.join(left[a:b])}\n    CUDA: {'; '.join(right[c:d])}")
    return complaints


def pairs(root, suffix, other):
    shaders = {p.relative_to(root / "shaders").with_suffix(""): p.read_text() for p in (root / "shaders").rglob(f"*{suffix}")}
    kernels = {p.relative_to(root / "cuda").with_suffix(""): p.read_text() for p in (root / "cuda").rglob(f"*{other}")}
    kernels = {stem: text for stem, text in kernels.items() if stem.parts[0] != "host"}
    return shaders, kernels


def twins(root, build):
    """The same stems in the same folders of shaders/ and cuda/, but for cuda/host, and the same statements in both."""
    complaints, checked = [], 0
    for suffix, other in SUFFIXES:
        shaders, kernels = pairs(root, suffix, other)
        for sides, language, end in ((shaders, "GLSL", suffix), (kernels, "CUDA", other)):
            lonely = sorted(sides.keys() - (kernels if sides is shaders else shaders).keys())
            complaints += [f"{PREFIX[language]}/{stem}{end}: has no twin, and does not say `{language} only: why`"
                           for stem in lonely if not re.search(rf"^// {language} only: \S", sides[stem], re.M)]
        for stem in sorted(shaders.keys() & kernels.keys()):
            checked += 1
            left, right = first_sentence(shaders[stem]), first_sentence(kernels[stem])
            if left != right or not left:
                complaints.append(f'{stem}: the first sentences differ\n  {suffix}: "{left}"\n  {other}: "{right}"')
            complaints += [f"{stem}: {complaint}" for complaint in differences(shaders[stem], kernels[stem])]
    if not checked:
        complaints.append("no twins found")
    return complaints, f"{checked} pairs of files"
