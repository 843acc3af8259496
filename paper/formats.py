# SPDX-License-Identifier: MIT
"""The records of each program as rows of one form: parameters, samples, median and interval in milliseconds."""


def rows_of(root):
    readers = {"spherepair frames 1": frames, "spherepair precision 1": precision,
               "spherepair contacts 1": contacts}
    if root.get("format") in readers:
        return readers[root["format"]](root)
    if "benchmarks" in root:
        return benchmarks(root)
    return root.get("measurements", root.get("records", []))


TRANSFERS = {"host": "through the host's memory", "registered": "GL's buffer, registered with CUDA",
              "imported": "CUDA's memory, imported by GL"}


def frames(root):
    """Of `spherepair frames`; `frame` and `frame_all` are also rows of the table `ablation`, a transfer without an image
    is a row of the table `interop`. A run of the works `loop` and `view` alone compares drawing in a window's context
    with drawing off screen, in the table `window`."""
    compares = {entry["work"] for entry in root["frames"]} == {"loop", "view"}
    rows, with_all = [], any(entry["work"] == "frame_all" for entry in root["frames"])
    for entry in root["frames"]:
        if "overlaps" in root and entry["work"] == "frame":
            continue  # timed along with the transfers; drawing has its own runs
        if entry["draw"] == "none" and entry["work"] in TRANSFERS:
            rows.append({**entry, "table": "interop", "way": TRANSFERS[entry["work"]], "scene": {"name": "uniform"}})
            continue
        row = {**entry, "table": "draw", "scene": {"name": "uniform"}}
        if compares:
            row |= {"table": "window", "window": root["window"]}
        rows.append(row)
        if with_all and entry["draw"] == "compute" and entry["work"] in ("frame", "frame_all"):
            rows.append({**row, "table": "ablation", "option": f"drawing, camera {entry['place']}",
                         "on": entry["work"] == "frame"})
    return rows


def precision(root):
    """Of `spherepair precision`: each time of a step with the error at the same time step, which is the same on every
    backend."""
    errors = {(entry["method"], entry["precision"], entry["k"]): entry["rms"] for entry in root["errors"]}
    rows = []
    for entry in root["times"]:
        key = entry["method"], entry["precision"], entry["k"]
        if key in errors:
            rows.append({**entry["sample"], **{name: value for name, value in entry.items() if name != "sample"},
                         "table": "precision", "scene": {"name": "random"}, "error_m": errors[key],
                         "simulated_s": root["settings"]["seconds"]})
    return rows


def contacts(root):
    """Of `spherepair contacts`: each run with the time of its steps and its error, and of earlier versions the steps by sum of impulses."""
    return [{**entry["sample"], **{name: value for name, value in entry.items() if name != "sample"},
             "table": table, "scene": {"name": "gas"}}
            for table in ("contact_runs", "contact_sums", "gas_steps") for entry in root.get(table, ())]


def benchmarks(root):
    """Of spherepair_bench, one row for all repetitions: the parameters are in the label and in the counters."""
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
