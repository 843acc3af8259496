# SPDX-License-Identifier: MIT
"""Records of `spherepair sets`: how many pairs are wrong, and why."""
from paper.records import Missing


def sets(machine):
    """The last record of `spherepair sets`."""
    found = [root for root in machine.sources.values() if root.get("format") == "spherepair sets 1"]
    if not found:
        raise Missing(f"{machine.name} has no record of `spherepair sets`")
    return found[-1]


def wrong(entry, prefix=""):
    return (entry[f"{prefix}missed"] + entry[f"{prefix}extra"]) / max(entry["right"], 1)


def least(entries):
    """Half a pair: the position of zero on a logarithmic axis."""
    return 0.5 / max(max(entry["right"], 1) for entry in entries)
