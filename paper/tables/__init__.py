# SPDX-License-Identifier: MIT
"""The tables, as LaTeX and as text."""
