# SPDX-License-Identifier: MIT
"""Wrong pairs against the closed form: by time step, by distance from the origin, and between steps."""
from paper.numbers.sets import least, sets, wrong
from paper.records import Missing
from paper.style import PAGE, SERIES, panels

NAME = "set-errors"
CAPTION = ("Missed and extra pairs, as a share of the right ones; at the lower edge: "
           "none. (a) After {seconds:g} s against the time step. (b) Against the distance from the origin: of "
           "spheres that are only stored (broad, grey), and after {seconds:g} s at a step of {far} s. Filled: with "
           "the nearest float32 positions, as collided; hollow: with positions in full precision. (c) Pairs "
           "that pass through each other and are never found to touch when tested once per step; line: "
           "expectation. Bars: two standard deviations. The swept test misses {swept}.")
MOTIONS = (("paper", "float32"), ("impact", "float32"), ("impact", "float64"), ("anchored", "float32"),
           ("anchored", "compensated"), ("anchored", "float64"))
MARKERS = {"float32": "o", "compensated": "s", "float64": "^"}
LINES = {"paper": "-", "impact": "--", "anchored": "-."}
COLORS = {"paper": "#8a8a8a", "impact": "#e0812b", "anchored": "#15396b"}


def far_exponent(root):
    return next(-entry["k"] for entry in root["motion"] if entry["offset"] > 0)


def caption(machine):
    root = sets(machine)
    missed = sum(entry["swept_missed"] for entry in root["contacts"])
    return CAPTION.format(seconds=root["settings"]["seconds"], far=f"$2^{{{far_exponent(root)}}}$",
                          swept="none" if missed == 0 else str(missed))


def source(machine):
    return machine.title_of([sets(machine)["id"]])


def draw_motion(axis, entries, along, bottom):
    for method, precision in MOTIONS:
        line = sorted((e for e in entries if (e["method"], e["precision"]) == (method, precision)),
                      key=lambda entry: entry[along])
        look = {"color": COLORS[method], "marker": MARKERS[precision]}
        positions = [entry[along] for entry in line]
        axis.plot(positions, [max(wrong(entry), bottom) for entry in line], linestyle=LINES[method],
                  label=f"{method} {precision}", **look)
        axis.plot(positions, [max(wrong(entry, "whole_"), bottom) for entry in line], linestyle="",
                  markerfacecolor="white", markersize=2.4, **look)


def draw_contacts(axis, contacts):
    for name in dict.fromkeys(entry["backend"] for entry in contacts):
        own = [entry for entry in contacts if entry["backend"] == name]
        look = {**SERIES[name if name != "cpu" else "cpu parallel"], "linestyle": ""}
        axis.errorbar([e["distance"] for e in own], [100 * e["missed"] / e["pairs"] for e in own],
                      yerr=[200 * e["deviation"] / e["pairs"] for e in own], capsize=1.5, elinewidth=0.7, **look)
    steps = [0.05 * k for k in range(1, 21 * int(max(e["distance"] for e in contacts)))]
    axis.plot(steps, [100 * (s * s / 12 if s <= 2 else 1 - 4 / (3 * s)) for s in steps], color="black", linewidth=0.7)
    axis.set(xlabel="distance per step (sums of radii)", ylim=(0, 100), ylabel="contacts missed (%)")
    axis.add_artist(axis.legend(loc="upper left"))


def draw(machine):
    root = sets(machine)
    near = [entry for entry in root["motion"] if entry["offset"] == 0]
    away = [entry for entry in root["motion"] if entry["offset"] > 0]
    if not (near and away and root["storage"] and root["contacts"]):
        raise Missing(f"{machine.name}: the run of `spherepair sets` lacks a part")
    bottom = least(root["motion"] + root["storage"])
    figure, (steps, offsets, contacts) = panels(PAGE, 2.5, 3)
    draw_motion(steps, near, "dt", bottom)
    steps.set(xscale="log", yscale="log", xlabel="time step (s)", ylabel="share of wrong pairs")
    steps.set_xscale("log", base=2)
    draw_motion(offsets, away, "offset", bottom)
    for precision, marker in MARKERS.items():
        line = [entry for entry in root["storage"] if entry["precision"] == precision]
        offsets.plot([entry["offset"] for entry in line], [max(wrong(entry), bottom) for entry in line], color="#bbbbbb",
                    marker=marker, markersize=8, label=f"stored as {precision}", linewidth=4, zorder=0)
    offsets.set(xscale="log", yscale="log", xlabel="distance from the origin (m)")
    keys = [line for line in offsets.get_lines() if not line.get_label().startswith("_")]
    draw_contacts(contacts, root["contacts"])
    contacts.legend(handles=keys, loc="upper left", bbox_to_anchor=(1.0, 1.0))
    for axis, title in ((steps, "(a) time step"), (offsets, "(b) distance"), (contacts, "(c) between steps")):
        axis.set_title(title, loc="left")
    return figure
