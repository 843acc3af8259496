# SPDX-License-Identifier: MIT
"""The answer at the head of the page, from the records: the time ratio of the shortest and of the longest recorded steps."""
from paper.numbers import leads
from paper.numbers.derived import matched
from paper.records import Missing

ABOUT_EQUAL = 1.1  # a ratio up to this hardly matters
WORDS = {"cuda": "faster in CUDA", "glsl": "faster in OpenGL", "equal": "about as fast in both",
         "mixed": "faster in one or the other, depending on the work"}


def ratios(machine):
    """(spheres, ratios OpenGL/CUDA) of the shortest step and of the longest: all that the answer states."""
    short = [leads.contest(*pair) for pair in matched(machine, table="step")]
    long = short + [leads.contest(*pair) for scene in ("random", "uniform") if machine.select(table="scale", scene=scene)
                    for pair in matched(machine, table="scale", scene=scene)]
    if not short:
        raise Missing(f"{machine.name} has no whole step that both APIs did")
    sizes = min(entry.n for entry in short), max(entry.n for entry in long)
    return [(n, [entry.ratio for entry in found if entry.n == n]) for n, found in zip(sizes, (short, long))]


def faster(found):
    """The API that no ratio contradicts; equal where none matters."""
    least, most = min(found), max(found)
    if 1 / ABOUT_EQUAL <= least and most <= ABOUT_EQUAL:
        return "equal"
    return "cuda" if least >= 1 else "glsl" if most <= 1 else "mixed"


def span(found):
    least, most = (f"{bound(found):.2f}x" for bound in (min, max))
    return least if least == most else f"{least} to {most}"


def answer(machine, recorded):
    """(the answer in words, the same with GPU and ratios), one sentence each."""
    if not all(machine.has(name) and not machine.backend(name)["software"] for name in ("glsl", "cuda")):
        raise Missing(f"{machine.name} has not run both OpenGL and CUDA on a GPU")
    (few, short), (many, long) = ratios(machine)
    sides = [WORDS[faster(found)] for found in (short, long)]
    words = f"Steps are {sides[0]}." if sides[0] == sides[1] else f"Short steps are {sides[0]}; long steps are {sides[1]}."
    where = f"the recorded {machine.backend('cuda')['device']}" if recorded else f"this machine's {machine.backend('cuda')['device']}"
    return words, (f"On {where}, OpenGL takes {span(short)} CUDA's time in a step of {few:,} spheres and {span(long)} in one of "
                   f"{many:,}.")


def why_not(machine):
    """Why this machine's own times do not answer the question."""
    on_gpu = [name for name in ("glsl", "cuda") if machine.has(name) and not machine.backend(name)["software"]]
    if not on_gpu:
        return "No GPU was found on this machine, so its times do not compare OpenGL with CUDA."
    if len(on_gpu) == 1:
        return f"On this machine's GPU only {'OpenGL' if on_gpu == ['glsl'] else 'CUDA'} ran, so its times compare nothing."
    return "This machine timed no whole step with both APIs."
