# SPDX-License-Identifier: MIT
"""One figure per module, a chart of records: NAME, CAPTION and draw(machine), which returns the figure or raises Missing."""
