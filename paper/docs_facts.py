# SPDX-License-Identifier: MIT
"""What README.md and docs/motion.md say of records, other than what headline.py does: each between `<!-- NAME: ... -->` and
`<!-- end -->`."""
import re
import textwrap

from paper import sources
from paper.records import DATA, Missing

ERRORS = (("euler", "float32"), ("symplectic", "float32"), ("paper", "float32"), ("paper-clamp", "float32"), ("impact-linear", "float64"),
          *((method, precision) for method in ("impact", "anchored") for precision in ("float32", "compensated", "float64")))
EXPONENTS = (4, 6, 8, 10)  # k of dt = 2^-k s


def require(holds, text):
    if not holds:
        raise Missing(f"the text says: {text}")


def paragraph(text):
    return textwrap.fill(text, 120, break_long_words=False, break_on_hyphens=False)


def older(machine):
    """Which records are of sources before today's."""
    checked = sorted(sources.checked(DATA / machine.name).items())
    stale, current = ([f"`{name}`" for name, entry in checked if bool(entry.stale) == wanted] for wanted in (True, False))
    if not stale:
        return "All records were made with the newest kernels and launch paths."
    named = f"these records were made: {', '.join(stale)}"
    if len(stale) > len(current):
        named = "the records were made" + (f", all but {', '.join(current)}" if current else "")
    return paragraph(f"Kernels and launches have become faster since {named}: [new times](docs/NOTES/launches.md).")


def errors(machine):
    """The table of errors of motion: the same on every backend."""
    def error(method, precision, k):
        found = {record.parameters["error_m"] for record in machine.need(
            table="precision", method=method, precision=precision, dt=2.0**-k)}
        require(len(found) == 1, "the errors are the same on every backend")
        value = found.pop()
        return f"{value:#.2g}" if value >= 0.01 else re.sub("e-0", "e-", f"{value:.1e}")
    powers = " | ".join(f"2{''.join('⁻' if c == '-' else '⁰¹²³⁴⁵⁶⁷⁸⁹'[int(c)] for c in str(-k))} s" for k in EXPONENTS)
    rows = [f"| `{method}` | {precision} | {' | '.join(error(method, precision, k) for k in EXPONENTS)} |"
            for method, precision in ERRORS]
    return "\n".join((f"| `--motion` | `--precision` | dt = {powers} |", "|---" * (2 + len(EXPONENTS)) + "|", *rows))


def wrong_pairs(machine):
    """What errors of motion do to the pairs, by the closed form."""
    root = machine.source("sets.json")
    seconds, n = root["settings"]["seconds"], root["settings"]["n"]
    rows = {(row["method"], row["precision"], row["offset"]): row for row in root["motion"] if row["k"] == 6}
    def wrong(method, precision, offset=0, bits=""):
        row = rows[method, precision, offset]
        return row[f"{bits}missed"] + row[f"{bits}extra"]
    exact = [wrong(method, precision) for method in ("impact", "anchored") for precision in ("compensated", "float64")]
    paper, right = rows["paper", "float32", 0], rows["anchored", "float32", 1e6]["right"]
    lost = [rows[method, "float32", 1e6]["missed"] / right for method in ("paper", "impact")]
    require(not any(exact), "in compensated and float64 `impact` and `anchored` get no pair wrong")
    require(min(lost) > 0.95 and wrong("anchored", "float64", 1e6, "whole_") == 0, "far from the origin only `anchored` serves")
    return "\n\n".join(paragraph(text) for text in (
        f"After {seconds:g} s at dt = 2⁻⁶ s {n:,} spheres have {paper['right']:,} pairs. In float32 `paper` misses "
        f"{paper['missed']:,} of them and adds {paper['extra']:,}. `impact` gets {wrong('impact', 'float32'):,} wrong and `anchored` "
        f"{wrong('anchored', 'float32'):,}. In compensated and float64 both get none wrong.",
        "Far from the origin, at 10⁶\u00a0m, a step in float32 no longer moves a sphere. There `paper` and `impact` lose more than "
        f"95\u00a0% of the pairs. `anchored` gets {100 * wrong('anchored', 'float32', 1e6) / right:.0f}\u00a0% wrong, because positions are "
        "rounded to float32. With all the bits of float64 it gets none wrong."))


PAGES = {"README.md": {"older": older}, "docs/motion.md": {"motion-errors": errors, "wrong-pairs": wrong_pairs}}


def filled(text, name, made):
    """The text with what is between these markers made anew; they must be there once."""
    text, count = re.subn(rf"(<!-- {name}: [^>]*-->\n).*?(?=<!-- end -->)", lambda found: f"{found[1]}\n{made}\n\n", text, flags=re.DOTALL)
    require(count == 1, f"<!-- {name}: ... --> once, not {count} times")
    return text


def updated(page, text, machine):
    for name, make in PAGES[page].items():
        text = filled(text, name, make(machine))
    return text
