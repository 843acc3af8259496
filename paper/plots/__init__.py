# SPDX-License-Identifier: MIT
"""One figure a module: NAME, CAPTION and draw(machine), which returns the figure or raises Missing."""
