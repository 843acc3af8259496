# SPDX-License-Identifier: MIT
"""SASS, NVIDIA's machine code, as cuobjdump and nvdisasm print it: the hot loop of a kernel and what it executes.

The hot loop is, of the innermost loops, the one with the most float instructions on its shortest way round: that which
is taken when no pair is near.
"""
import re
from collections import Counter
from dataclasses import dataclass

LINE = re.compile(r"/\*([0-9a-f]{4,})\*/\s+([^;]+?)\s*;")
LABEL = re.compile(r"^\s*(\.L\w+):")
TARGET = re.compile(r"\((\.L\w+)\)|\b0x([0-9a-f]+)$")
CLASSES = {  # all others are integer arithmetic and moves
    "float": "FADD FMUL FFMA FSWZADD MUFU HADD2 HMUL2 HFMA2 DADD DMUL DFMA HMMA DMMA",
    "compare": "FSETP FSET FMNMX FCHK HSETP2 HSET2 HMNMX2 DSETP ISETP UISETP IMNMX VIMNMX VIMNMX3 PLOP3 UPLOP3 R2P P2R VOTE VOTEU",
    "shared": "LDS LDSM STS ATOMS",
    "global": "LD LDG LDL LDGSTS ST STG STL ATOM ATOMG RED TEX TLD TLD4 TXD",
    "constant": "LDC ULDC LDCU",
    "control": "BRA BRX JMP CALL RET EXIT BSSY BSYNC BREAK BAR WARPSYNC YIELD NOP DEPBAR LDGDEPBAR MEMBAR NANOSLEEP BMOV",
}
CLASS_OF = {opcode: name for name, opcodes in CLASSES.items() for opcode in opcodes.split()}
ENDS = ("EXIT", "RET", "BRX", "JMX", "BPT")  # no next instruction, unless predicated


@dataclass(frozen=True)
class Instruction:
    address: int
    text: str
    target: int = None  # of a branch

    @property
    def opcode(self):
        return re.sub(r"^@\S+\s+", "", self.text).split()[0].split(".")[0]

    @property
    def kind(self):
        return CLASS_OF.get(self.opcode, "integer")

    @property
    def conditional(self):
        """By its predicate, or a branch by an operand before its target."""
        return self.text.startswith("@") or self.target is not None and "," in self.text


def parse(text):
    """The instructions of one kernel, branches with their targets' addresses."""
    found, labels, waiting = [], {}, []
    for line in text.splitlines():
        label, instruction = LABEL.match(line), LINE.search(line)
        if label:
            waiting.append(label[1])
        if instruction:
            found.append((int(instruction[1], 16), " ".join(instruction[2].split())))
            labels.update({name: found[-1][0] for name in waiting})
            waiting = []
    return [Instruction(address, words, target_of(words, labels)) for address, words in found]


def target_of(words, labels):
    branch = re.match(r"(?:@\S+ )?(?:BRA|JMP|CALL)\b", words) and TARGET.search(words)
    if not branch:
        return None
    return labels.get(branch[1]) if branch[1] else int(branch[2], 16)


def successors(code):
    """index -> indices, of the instructions that may come next."""
    index = {instruction.address: k for k, instruction in enumerate(code)}
    following = []
    for k, instruction in enumerate(code):
        falls = instruction.conditional or instruction.opcode == "CALL" or instruction.target is None and instruction.opcode not in ENDS
        to = [index[instruction.target]] if instruction.target in index else []
        following.append(to + [k + 1] * (falls and k + 1 < len(code)))
    return following


def reached(start, neighbours, barred=None):
    """Nodes on the paths from a node, not beyond the barred one."""
    seen, left = {start}, [start]
    while left:
        node = left.pop()
        new = [] if node == barred else [other for other in neighbours[node] if other not in seen]
        seen.update(new)
        left += new
    return seen


def loops(code):
    """head -> indices of its natural loop: of the edges back to an instruction that lies on every way to them."""
    following = successors(code)
    before = [[] for _ in code]
    for k, others in enumerate(following):
        for other in others:
            before[other].append(k)
    executed, found = reached(0, following), {}
    for k in executed:
        for head in following[k]:
            joins = len(before[head]) > 1 or head == 0  # as a loop's head does
            inside = reached(k, before, barred=head) & executed if joins else set()
            if inside and (0 not in inside or head == 0):
                found[head] = found.get(head, set()) | inside
    return found


def way_round(head, inside, following):
    """The fewest instructions from a loop's head back to it, in order."""
    came_from, left = {head: None}, [head]
    for node in left:
        if head in following[node]:
            way = []
            while node is not None:
                way.append(node)
                node = came_from[node]
            return way[::-1]
        new = [other for other in following[node] if other in inside and other not in came_from]
        came_from.update(dict.fromkeys(new, node))
        left += new
    raise ValueError(f"instruction {head} is not the head of a loop")


@dataclass(frozen=True)
class Loop:
    whole: list  # instructions, in the order of their addresses
    way: list  # those of the shortest way round

    def counts(self):
        kinds = Counter(instruction.kind for instruction in self.way)
        return {"instructions": len(self.way), "of_whole_loop": len(self.whole),
                "by_class": {name: kinds[name] for name in (*CLASSES, "integer")},
                "by_opcode": dict(Counter(instruction.opcode for instruction in self.way).most_common())}

    def listing(self):
        """A line per instruction; those of the shortest way round are marked."""
        marked = {instruction.address for instruction in self.way}
        return "".join(f"{'|' if one.address in marked else ' '} {one.address:05x}  {one.text}\n" for one in self.whole)


def floats(loop):
    return sum(instruction.kind == "float" for instruction in loop.way)


def hot_loop(code):
    """The Loop, or nothing where no loop has a float instruction."""
    found, following = loops(code) if code else {}, successors(code)
    innermost = [head for head, inside in found.items()
                 if not any(other != head and other in inside and found[other] < inside for other in found)]
    made = [Loop([code[k] for k in sorted(found[head])], [code[k] for k in way_round(head, found[head], following)])
            for head in innermost]
    return max((loop for loop in made if floats(loop)), key=floats, default=None)


def registers_named(code):
    """The highest register that is named, plus one."""
    return max((int(number) for one in code for number in re.findall(r"\bR(\d+)\b", one.text)), default=-1) + 1
