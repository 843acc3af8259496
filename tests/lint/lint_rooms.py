# SPDX-License-Identifier: MIT
"""Rooms and arrows: who may include and link whom, as the block in docs/ARCHITECTURE.md has them."""

import re

MOST_FILES = 25  # of a room
INCLUDING = (".h", ".cpp", ".cu", ".cuh", ".comp", ".vert", ".frag", ".glsl")


def arrows(root):
    """From each room to those that it may include directly: the lines `room <- room room` of the block `rooms`."""
    block = re.search(r"^```rooms\n(.*?)^```", (root / "docs/ARCHITECTURE.md").read_text(), re.M | re.S)
    lines = [line.split("#")[0].split("->") for line in block[1].splitlines() if line.split("#")[0].strip()]
    return {line[0].strip(): line[1].split() if len(line) > 1 else [] for line in lines}


def reach(room, table, above=()):
    """The room and all that it includes through others; a cycle raises ValueError."""
    if room in above:
        raise ValueError(f"the arrows go in a circle: {' -> '.join([*above, room])}")
    found = {room}
    for target in table[room]:
        found |= reach(target, table, (*above, room))
    return found


def room_of(path):
    return str(path.parent)


def include_complaints(root, table, files):
    complaints = []
    for path in files:
        room = room_of(path)
        if room not in table:
            complaints.append(f"{path}: docs/ARCHITECTURE.md has no room {room}")
            continue
        allowed = reach(room, table)
        for name in re.findall(r'^#include "(.*)"', (root / path).read_text(), re.M):
            target = root / name
            if not target.is_file():
                complaints.append(f'{path}: #include "{name}": there is no such file; write it from the root')
            elif room_of(target.relative_to(root)) not in allowed:
                complaints.append(f"{path}: includes {name}, but {room} stands below {room_of(target.relative_to(root))}")
    return complaints


def link_complaints(root, table):
    """add_room(FOLDER rooms and libraries): the rooms among them must be within its reach."""
    complaints = []
    folders = {room.replace("/", "_"): room for room in table}
    for path in [root / "CMakeLists.txt", *sorted(root.glob("*/CMakeLists.txt"))]:
        for folder, linked in re.findall(r"^\s*add_room\(([\w/]+)\s*([^)]*)\)", path.read_text(), re.M):
            if folder not in table:
                complaints.append(f"{path.relative_to(root)}: docs/ARCHITECTURE.md has no room {folder}")
                continue
            for target in linked.split():
                if target in folders and folders[target] not in reach(folder, table):
                    complaints.append(f"{path.relative_to(root)}: {folder} links {folders[target]} against the arrows")
    return complaints


def rooms(root, build):
    table = arrows(root)
    tops = {room.split("/")[0] for room in table}
    files = [p.relative_to(root) for top in sorted(tops) for p in sorted((root / top).rglob("*")) if p.suffix in INCLUDING]
    try:
        complaints = include_complaints(root, table, files) + link_complaints(root, table)
    except ValueError as circle:
        return [str(circle)], "the arrows"
    for room in table:
        count = sum(1 for path in files if room_of(path) == room)
        if count == 0:
            complaints.append(f"{room}: docs/ARCHITECTURE.md has this room, the tree has not")
        if count > MOST_FILES:
            complaints.append(f"{room}: {count} files, more than {MOST_FILES}: make two rooms of it")
    return complaints, f"{len(files)} files in {len(table)} rooms"
