# SPDX-License-Identifier: MIT
"""What is derived from records: ratios, contests, leads; and the numbers of the prose (prose_*.py) as LaTeX macros."""
