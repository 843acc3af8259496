#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the same spheres through spherepair and LAMMPS, an independent program, and writes both side by side.

    paper/lammps/compare.py [--program PATH] [--lammps lmp] [--output paper/data/lammps/results.json] [--n 1000]

Two spheres that run into each other (their rebound speed, by restitution and steps a contact), and a gas in a closed
box that cools (its kinetic energy). LAMMPS: pair_style gran/hooke without friction, its damper cut where it would pull
(limit_damping), as ours; the same stiffness, damping, masses, walls and time step.
"""
import argparse
import csv
import json
import math
import pathlib
import re
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
DENSITY = 1000.0  # kg/m^3, of both


def damping_ratio(restitution):
    """The damping over its critical value with which a damper that never pulls leaves this share of the speed (Schwager
    and Poeschel, Granular Matter 9 (2007) 465)."""
    def left(b):
        root = math.sqrt(1 - b * b)
        return math.exp(-b / root * (math.pi - math.atan2(2 * b * root, 1 - 2 * b * b)))
    low, high = 0.0, 0.999
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if left(middle) > restitution else (low, middle)
    return (low + high) / 2 if restitution < 1 else 0.0


def mass(radius):
    return DENSITY * 4 / 3 * math.pi * radius**3


def text_of(command, **more):
    done = subprocess.run([str(word) for word in command], check=False, capture_output=True, text=True, **more)
    if done.returncode:
        raise SystemExit(f"{' '.join(map(str, command))} failed:\n{(done.stdout + done.stderr)[-3000:]}")
    return done.stdout


def spheres_of(program, folder, scene):
    """x, y, z, radius, vx, vy, vz of each sphere at the start."""
    file = folder / "start.csv"
    text_of([program, "run", "--backend", "cpu", *scene, "--spheres", file])
    with file.open() as lines:
        return [[float(row[name]) for name in ("x", "y", "z", "radius", "vx", "vy", "vz")] for row in csv.DictReader(lines)]


def spherepair(program, folder, scene, options, steps, every):
    """(the chosen stiffness, the chosen time step, the kinetic energies after every so many steps)"""
    file = folder / "statistics.csv"
    said = text_of([program, "run", "--backend", "cpu", *scene, "--contact", "spring", *options, "--steps", steps,
                    "--statistics", file, "--statistics-every", every])
    stiffness, dt = re.search(r"stiffness ([0-9.e+-]+).*?dt = ([0-9.e+-]+)", said, re.DOTALL).groups()
    with file.open() as lines:
        rows = list(csv.DictReader(lines))
    return float(stiffness), float(dt), [float(row["kinetic_J"]) for row in rows]


def write_data(file, spheres, low, high):
    lines = ["spheres", "", f"{len(spheres)} atoms", "1 atom types", ""]
    lines += [f"{low[k]!r} {high[k]!r} {axis}lo {axis}hi" for k, axis in enumerate("xyz")]
    lines += ["", "Atoms # sphere", ""]
    lines += [f"{k + 1} 1 {2 * s[3]!r} {DENSITY!r} {s[0]!r} {s[1]!r} {s[2]!r}" for k, s in enumerate(spheres)]
    lines += ["", "Velocities", ""]
    lines += [f"{k + 1} {s[4]!r} {s[5]!r} {s[6]!r} 0 0 0" for k, s in enumerate(spheres)]
    file.write_text("\n".join(lines) + "\n")


def lammps(command, folder, script, spheres, box, **variables):
    """Kinetic energies that the run prints."""
    data = folder / "spheres.data"
    write_data(data, spheres, *box)
    words = [word for name, value in {"data": data, **variables}.items() for word in ("-var", name, value)]
    said = text_of([command, "-in", HERE / script, "-log", "none", *words], cwd=folder)
    return [float(row[1]) for row in re.findall(r"^\s*(\d+)\s+([0-9.e+-]+)\s*$", said, re.MULTILINE)]


def two_spheres(program, command, folder, restitution, steps_a_contact):
    scene = ["--scene", "collide2", "--n", 2]
    spheres = spheres_of(program, folder, scene)
    options = ["--restitution", restitution, "--stiffness", 1e8]
    reduced = mass(spheres[0][3]) / 2
    dt = math.pi * math.sqrt(reduced / 1e8) / steps_a_contact
    speed = abs(spheres[0][4] - spheres[1][4]) + abs(spheres[0][5] - spheres[1][5]) + abs(spheres[0][6] - spheres[1][6])
    gap = math.dist(spheres[0][:3], spheres[1][:3]) - 2 * spheres[0][3]
    steps = int(gap / speed / dt) + 3 * steps_a_contact
    stiffness, _, ours = spherepair(program, folder, scene, [*options, "--dt", repr(dt)], steps, steps)
    theirs = lammps(command, folder, "two_spheres.lmp", spheres, ([-10] * 3, [10] * 3), stiffness=repr(stiffness),
                    damping=repr(2 * damping_ratio(restitution) * math.sqrt(stiffness / reduced)), dt=repr(dt),
                    steps=steps, every=steps)
    return {"restitution": restitution, "steps_a_contact": steps_a_contact,
            "spherepair": math.sqrt(ours[-1] / ours[0]), "lammps": math.sqrt(theirs[-1] / theirs[0])}


def cooling(program, command, folder, n, restitution, steps, every):
    packing_fraction = 0.3
    scene = ["--scene", "gas", "--n", n, "--packing-fraction", packing_fraction]
    spheres = spheres_of(program, folder, scene)
    radius = spheres[0][3]
    side = math.ceil(round(n ** (1 / 3), 9)) * 2 * radius * (math.pi / 6 / packing_fraction) ** (1 / 3)
    stiffness, dt, ours = spherepair(program, folder, scene, ["--restitution", restitution], steps, every)
    damping = [2 * damping_ratio(restitution) * math.sqrt(stiffness / m) for m in (mass(radius) / 2, mass(radius))]
    walls = {f"{end}_{axis}": value for axis in "xyz" for end, value in (("low", 0), ("high", repr(side)))}
    theirs = lammps(command, folder, "gas.lmp", spheres, ([-1] * 3, [side + 1] * 3), stiffness=repr(stiffness),
                    damping=repr(damping[0]), wall_damping=repr(damping[1]), dt=repr(dt), steps=steps, every=every, **walls)
    return {"n": n, "packing_fraction": packing_fraction, "restitution": restitution, "stiffness": stiffness, "dt": dt,
            "steps": [k * every for k in range(len(ours))], "spherepair_J": ours, "lammps_J": theirs}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/bench/spherepair")
    parser.add_argument("--lammps", default="lmp")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "paper/data/lammps/results.json")
    parser.add_argument("--n", type=int, default=1000, help="spheres of the gas")
    parser.add_argument("--steps", type=int, default=24000, help="of the gas")
    options = parser.parse_args()
    version = re.search(r"Molecular Massively Parallel Simulator - (.*)", text_of([options.lammps, "-h"]))[1]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        rebounds = [two_spheres(options.program, options.lammps, folder, restitution, steps)
                    for restitution in (1, 0.9, 0.7, 0.5) for steps in (40, 320)]
        gas = cooling(options.program, options.lammps, folder, options.n, 0.9, options.steps, options.steps // 40)
    context = json.loads(text_of([options.program, "devices", "--no-gpu", "--json", "-"]))["context"]
    results = {"lammps": version, "date": context["date"], "build": context["build"], "two_spheres": rebounds, "gas": gas}
    options.output.parent.mkdir(parents=True, exist_ok=True)
    options.output.write_text(json.dumps(results, indent=1) + "\n")
    print("restitution  steps  spherepair    LAMMPS")
    for row in rebounds:
        print(f"{row['restitution']:11}  {row['steps_a_contact']:5}  {row['spherepair']:10.6f}{row['lammps']:10.6f}")
    print("\n    step   spherepair J      LAMMPS J    ratio")
    for step, ours, theirs in list(zip(gas["steps"], gas["spherepair_J"], gas["lammps_J"]))[::4]:
        print(f"{step:8}  {ours:13.7g} {theirs:13.7g} {ours / theirs:8.5f}")


if __name__ == "__main__":
    main()
