# SPDX-License-Identifier: MIT
"""The table of kernels against their shaders: which buffers each reads and which it writes, in any variant."""

import re

MOVES_POINTERS = ("AccessChain", "InBoundsAccessChain")


def slots_by_name(root):
    """The slots of each buffer, by its name in kernels."""
    layout = dict(re.findall(r"#define SLOT_(\w+) (\d+)", (root / "common/shared/layout.h").read_text()))
    rows = re.findall(r"(one|three)\((\w+), [^,]+, (\w+),", (root / "common/device/buffer_list.h").read_text())
    return {name: {int(layout[slot]) + k for k in range(3 if kind == "three" else 1)} for kind, slot, name in rows}


def table(root):
    """The slots that each kernel of the table reads and writes: {name: (reads, writes)}."""
    slots = slots_by_name(root) | {"none": set()}
    text = (root / "common/device/kernel_list.h").read_text().replace("\\\n", " ")
    of = lambda names: set().union(*(slots[name] for name in re.findall(r"\w+", names)))
    return {name: (of(reads), of(writes)) for name, reads, writes in re.findall(r"each\((\w+), ([^,]+), ([^,)]+)\)", text)}


def used_slots(assembly):
    """The bindings of storage blocks that a shader reads and those that it writes."""
    of_buffers = "BufferBlock", "Uniform"  # as SPIR-V has them until 1.3
    if "StorageBuffer" in assembly:
        of_buffers = "Block", "StorageBuffer"
    blocks = set(re.findall(rf"OpDecorate (%\w+) {of_buffers[0]}", assembly))
    length = {name: 1 for name in blocks}
    constants = dict(re.findall(r"(%\w+) = OpConstant %uint (\d+)", assembly))
    for name, block, count in re.findall(r"(%\w+) = OpTypeArray (%\w+) (%\w+)", assembly):
        if block in blocks:
            length[name] = int(constants[count])
    pointed = dict(re.findall(rf"(%\w+) = OpTypePointer {of_buffers[1]} (%\w+)", assembly))
    first = dict(re.findall(r"OpDecorate (%\w+) Binding (\d+)", assembly))
    slots = {variable: set(range(int(first[variable]), int(first[variable]) + length[pointed[pointer]]))
             for variable, pointer in re.findall(rf"(%\w+) = OpVariable (%\w+) {of_buffers[1]}$", assembly, re.M)
             if pointed[pointer] in length}
    reads, writes = set(), set()
    for result, operation, operands in re.findall(r"^ *(?:(%\w+) = )?Op(\w+) (.*)$", assembly, re.M):
        used = next((slots[word] for word in operands.split() if word in slots), set())
        if used and operation in MOVES_POINTERS:
            slots[result] = used
        elif operation.startswith("Atomic"):
            reads, writes = reads | used, writes | used
        elif operation == "Load":
            reads |= used
        elif operation == "Store":
            writes |= used
        elif used and operation not in ("Variable", "Decorate", "Name", "MemberName", "EntryPoint"):
            raise ValueError(f"Op{operation} of a buffer: what does it do to it?")
    return reads, writes


def complaints(root, kernel, found):
    """`found`: what used_slots says of each variant."""
    names = {slot: name for name, slots in slots_by_name(root).items() for slot in slots}
    stated = table(root).get(kernel, (set(), set()))
    for verb, says, does in zip(("reads", "writes"), stated, (set().union(*sets) for sets in zip(*found))):
        for slot in sorted(does - says):
            yield f"{kernel}: {verb} {names[slot]}, which common/device/kernel_list.h does not say"
        for slot in sorted(says - does):
            yield f"{kernel}: never {verb} {names[slot]}, as common/device/kernel_list.h says"
