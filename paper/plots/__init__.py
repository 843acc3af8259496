# SPDX-License-Identifier: MIT
"""One figure per module: NAME, CAPTION and draw(machine), which returns the figure or raises Missing."""
