# SPDX-License-Identifier: MIT
"""The groups of the page, and the short title of each figure and table."""

HEAD = ("ratio-by-duration", "claims")  # right below the answer

GROUPS = {
    "Speed": {
        "ratio-by-duration": "OpenGL against CUDA by work", "claims": "Main claims", "apis": "Three APIs",
        "glsl-against-cuda": "OpenGL against CUDA by size", "step": "Whole steps", "methods": "Search methods",
        "dimensions": "Ways to test all pairs", "group-sizes": "Group sizes", "arrangements": "Small groups",
        "grid": "The grid", "grid-sizes": "The grid by size", "crossover": "All pairs or grid", "peers": "Other systems",
        "energy": "Energy"},
    "Launches and kernels": {
        "three-apis": "OpenGL, Vulkan and CUDA", "opening": "First use", "launch-paths": "Ways to launch", "overhead": "Launch overhead", "extensions": "OpenGL without extensions", "kernel-pairs": "Kernels alone",
        "phases": "Kernels of a step", "grid-phases": "Kernels of the grid",
        "counters": "Limits of CUDA's kernels", "ablation": "Ablations", "code": "Lines of code"},
    "Exactness and equality": {
        "exactness": "Cost of exactness", "naive": "Errors of the naive test", "stress": "Stress catalogue",
        "counts": "Colliding spheres", "suite": "Test suite"},
    "Motion and error": {
        "work-precision": "Error against time", "work-precision-overlay": "Error against time by backend",
        "set-errors": "Wrong pairs by motion"},
    "Contacts": {
        "contacts": "Steps with contacts", "contact-precision": "Error of contacts", "settling": "Settling spheres"},
    "Drawing": {
        "drawing": "Drawing", "loop": "A whole loop", "frame-rates": "Frames per second", "interop": "From CUDA to OpenGL",
        "transfer": "Hidden transfers", "animations": "The two animations", "same-frame": "The same frame",
        "closeup": "Mesh and exact sphere"},
    "Scale and limits": {
        "scale": "From few to many spheres", "floor": "Distance from the floor", "peak-rates": "Peak rates"},
    "The original paper": {
        "table1": "Table 1", "table1-p95": "Table 1, slowest rounds", "paper-times": "Figure 5"},
    "The runs": {"machine": "Machine and run", "variation": "Spread of the times"},
}

NEEDS_GPU = {"ratio-by-duration", "claims", "glsl-against-cuda", "methods", "energy", "three-apis", "apis", "opening", "launch-paths", "kernel-pairs", "phases",
             "grid-phases", "floor", "interop", "transfer", "loop", "extensions"}  # both APIs on one, or its timers

OF_NO_MACHINE = {"code", "peers"}  # mostly measured elsewhere: shown once


def title_of(name):
    return next((titles[name] for titles in GROUPS.values() if name in titles), name)


def left_out(names, compares_apis):
    """A line for each reason why this machine lacks something."""
    gpu = [] if compares_apis else [name for name in names if name in NEEDS_GPU]
    others = [name for name in names if name not in gpu]
    reasons = ((gpu, "a GPU with OpenGL and CUDA"), (others, "measurements that this run lacks; paper/record makes them all"))
    return [f"{len(chosen)} {'figures and tables need' if len(chosen) > 1 else 'figure or table needs'} {reason}: {', '.join(title_of(name) for name in chosen)}."
            for chosen, reason in reasons if chosen]
