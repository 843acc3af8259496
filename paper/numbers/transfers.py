# SPDX-License-Identifier: MIT
"""Records of `spherepair frames --transfer`: OpenGL drawing of CUDA's spheres."""
from paper.records import Missing

MOST_TRANSFERRED = 10**6  # spheres in the prose; with more, GL's points take longer than everything else
ALONE = {"none": ("host", "registered", "imported")}  # works of a transfer without an image


def overlaps(machine):
    """All records of transfers, merged."""
    roots = [root for root in machine.sources.values() if root.get("overlaps")]
    if not roots:
        raise Missing(f"{machine.name} has no record of `spherepair frames --transfer`")
    whole = {key: [entry for root in roots for entry in root[key]] for key in ("overlaps", "frames")}
    return whole | {"id": ", ".join(root["id"] for root in roots)}


def hidden(root, entry):
    """Milliseconds that pipelining saves, and the bounds from the intervals of the three medians; negative: it costs."""
    rows = {row["work"]: row for row in root["frames"] if row["n"] == entry["n"] and
            row["draw"] in (entry["draw"], "none") and row["work"] not in ALONE.get(row["draw"], ())}
    (least, most), (step_least, step_most), (both_least, both_most) = (
        rows[work]["interval_ms"] for work in (entry["transfer"], "step", f"{entry['transfer']}_pipelined"))
    return (entry["frame_ms"] + entry["step_ms"] - entry["pipelined_ms"], least + step_least - both_most,
            most + step_most - both_least)
