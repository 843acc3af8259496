# SPDX-License-Identifier: MIT
"""A deliberate fault: what is replaced by what, where, and the ctest entries that should find it first."""


def mutant(name, file, old, new, *tests):
    return {"name": name, "file": file, "old": old, "new": new, "tests": list(tests)}
