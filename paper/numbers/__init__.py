# SPDX-License-Identifier: MIT
"""What is derived from records: ratios, ranks, leads; and the numbers of the prose (prose_*.py) as LaTeX macros."""
