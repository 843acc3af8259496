# SPDX-License-Identifier: MIT
"""The answer at the head of the page, from the records: the time ratio of short steps and of the longest recorded ones."""
from paper.numbers import apis
from paper.numbers.contests import SHORT, contests, ratio_span, several
from paper.numbers.ratios import extent
from paper.records import APIS, DATA, Machine, Missing

ABOUT_EQUAL = 1.1  # a ratio up to this hardly matters
WORDS = {"cuda": "faster in CUDA", "opengl": "faster in OpenGL", "equal": "about as fast in both",
         "mixed": "faster in one or the other, depending on the work"}


def steps(machine):
    """(contests of short whole steps, contests of the largest size), by all pairs; only those of several processes where there
    are any."""
    found = contests(machine)
    found = [entry for entry in several(found) or found if entry.table in ("step", "scale")]
    short = [entry for entry in found if entry.table == "step" and entry.n <= SHORT]
    most = max((entry.n for entry in found), default=0)
    if not short or most <= SHORT:
        raise Missing(f"{machine.name} has no steps of up to {SHORT:,} spheres and of more that both APIs did")
    return short, [entry for entry in found if entry.n == most]


def faster(found):
    """The API that no decided ratio contradicts; equal where none of them matters."""
    middles = [entry.ratio.middle for entry in found if entry.ratio.decided]
    if all(1 / ABOUT_EQUAL <= middle <= ABOUT_EQUAL for middle in middles):
        return "equal"
    return "cuda" if min(middles) > 1 else "opengl" if max(middles) < 1 else "mixed"


def sizes(found):
    least, most = (f"{bound(entry.n for entry in found):,}" for bound in (min, max))
    return least if least == most else f"{least} to {most}"


def through_vulkan(three):
    """What Vulkan makes of the same GLSL, as recorded."""
    low, high = apis.short_steps(three).ratios["Vulkan"]
    return (f" In short steps the same GLSL through Vulkan takes {low:.1f}x to {high:.1f}x the time of a CUDA graph of one step "
            f"({three.backend('cuda')['device']}).")


def answer(machine, recorded):
    """(the answer in words, the same with GPU and ratios), one sentence each."""
    if not all(machine.has(name) and not machine.backend(name)["software"] for name in ("opengl", "cuda")):
        raise Missing(f"{machine.name} has not run both OpenGL and CUDA on a GPU")
    short, long = steps(machine)
    sides = [WORDS[faster(found)] for found in (short, long)]
    words = f"Steps are {sides[0]}." if sides[0] == sides[1] else f"Short steps are {sides[0]}; long steps are {sides[1]}."
    where = f"the recorded {machine.backend('cuda')['device']}" if recorded else f"this machine's {machine.backend('cuda')['device']}"
    return words, (f"On {where}, OpenGL takes {ratio_span(short)} CUDA's time in steps of {sizes(short)} spheres and {ratio_span(long)} "
                   f"in steps of {sizes(long)} ({extent([entry.ratio for entry in short + long])})."
                   + (through_vulkan(Machine(DATA / APIS, whole=False)) if recorded else ""))


def why_not(machine):
    """Why this machine's own times do not answer the question."""
    on_gpu = [name for name in ("opengl", "cuda") if machine.has(name) and not machine.backend(name)["software"]]
    if not on_gpu:
        return "No GPU was found on this machine, so its times do not compare OpenGL with CUDA."
    if len(on_gpu) == 1:
        return f"On this machine's GPU only {'OpenGL' if on_gpu == ['opengl'] else 'CUDA'} ran, so its times compare nothing."
    return "This machine timed no whole step with both APIs."
