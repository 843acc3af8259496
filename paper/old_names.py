# SPDX-License-Identifier: MIT
"""New names for what the recorded runs in data/ call otherwise; applied once, when a record is loaded.

The records were written by earlier versions of the program and stay as they are. This file goes when they are recorded
again.
"""
FILES = {"skips.json": "ablate.json", "frames_hand_over.json": "frames_transfer.json",
         "frames_hand_over_1e8.json": "frames_transfer_1e8.json"}
KEYS = {"skip": "option", "work_a_step": "work_per_step", "beside": "overlapped", "answers": "configurations",
        "ceilings": "peak_rates", "ceiling_per_second": "peak_per_second", "hand_over": "transfer",
        "picture_ms": "frame_ms", "clusters_put_off": "clusters_deferred", "took": "chosen", "given_up": "stopped"}
STAGES = {"settle": "resolve_undecided", "place": "evaluate_positions", "draw_counts": "draw_unsort_counts",
          "draw_pyramid": "draw_hiz_pyramid", "draw_pyramid_near": "draw_hiz_pyramid_near",
          "draw_pyramid_far": "draw_hiz_pyramid_far", "draw_seen": "draw_previously_visible",
          "ceiling_copy": "peak_copy", "ceiling_atomics": "peak_atomics", "ceiling_issue": "peak_issue",
          "ceiling_words": "peak_words"}
KEYS_WITHIN = {"device_stages_ms": STAGES, "device_stages_interval_ms": STAGES, "compile_ms": STAGES,
               "contacts": {"way": "distance"}}  # enclosing key -> names of the keys within
VALUES = {"table": {"skips": "ablation", "ceilings": "peak_rates"}, "work": {"move and place": "move and evaluate"},
          "skip": {"sparse_buffers": "large_pages"},
          "kernel": STAGES}  # key -> names of its values
LABELS = {" ceiling ": " peak ", "move and place": "move and evaluate"}  # parts of labels


def label(text):
    for old, new in LABELS.items():
        text = text.replace(old, new)
    return text


def renamed(value, key=None, names=KEYS):
    """The same record with new names; `key` is the one that the value stands under, `names` are those of its keys."""
    if isinstance(value, dict):
        return {names.get(name, name): renamed(inner, name, {**KEYS, **KEYS_WITHIN.get(name, {})})
                for name, inner in value.items()}
    if isinstance(value, list):
        return [renamed(inner, key, names) for inner in value]
    if not isinstance(value, str):
        return value
    return label(value) if key == "label" else VALUES.get(key, {}).get(value, value)
