# SPDX-License-Identifier: MIT
"""What each program writes, as rows of one form: parameters, and samples, median and interval in milliseconds."""


def rows_of(root):
    readers = {"spherepair frames 1": frames, "spherepair precision 1": precision}
    if root.get("format") in readers:
        return readers[root["format"]](root)
    if "benchmarks" in root:
        return benchmarks(root)
    return root.get("measurements", root.get("records", []))


HAND_OVERS = {"host": "through the host's memory", "registered": "GL's buffer, registered with CUDA",
              "imported": "CUDA's memory, imported by GL"}


def frames(root):
    """Of `spherepair frames`; a picture with and without its skips is also a row of the table `skips`, a hand-over
    without a picture one of the table `interop`."""
    rows, with_all = [], any(entry["work"] == "frame_all" for entry in root["frames"])
    for entry in root["frames"]:
        if "overlaps" in root and entry["work"] == "frame":
            continue  # of a run of hand-overs, beside which it stands; drawing has runs of its own
        if entry["draw"] == "none" and entry["work"] in HAND_OVERS:
            rows.append({**entry, "table": "interop", "way": HAND_OVERS[entry["work"]], "scene": {"name": "uniform"}})
            continue
        row = {**entry, "table": "draw", "scene": {"name": "uniform"}}
        rows.append(row)
        if with_all and entry["draw"] == "compute" and entry["work"] in ("frame", "frame_all"):
            rows.append({**row, "table": "skips", "skip": f"drawing, camera {entry['place']}",
                         "on": entry["work"] == "frame"})
    return rows


def precision(root):
    """Of `spherepair precision`: each time of a step with the error at the same time step, whose bits are the same
    everywhere, so that any backend's will do."""
    errors = {(entry["method"], entry["precision"], entry["k"]): entry["rms"] for entry in root["errors"]}
    rows = []
    for entry in root["times"]:
        key = entry["method"], entry["precision"], entry["k"]
        if key in errors:
            rows.append({**entry["sample"], **{name: value for name, value in entry.items() if name != "sample"},
                         "table": "precision", "scene": {"name": "random"}, "error_m": errors[key],
                         "simulated_s": root["settings"]["seconds"]})
    return rows


def benchmarks(root):
    """Of spherepair_bench, one row for all repetitions: parameters stand in the label and in the counters."""
    rows = {}
    for entry in root["benchmarks"]:
        if entry["run_type"] != "iteration" or entry.get("error_occurred"):
            continue
        words = dict(word.split("=", 1) for word in entry["label"].split())
        counters = {name: int(entry[name]) for name in ("n", "block") if name in entry}
        row = rows.setdefault(entry["name"], {"table": "sweep", "samples_ms": [], **words, **counters,
                                              "scene": {"name": words["scene"]}, "label": entry["name"]})
        row["samples_ms"].append(entry["real_time"])
    return list(rows.values())
