# SPDX-License-Identifier: MIT
"""The paper's figures, tables and numbers, made from the recorded runs in data/.

sources, spread, formats <- records, text, style <- numbers <- plots, images, tables <- headline, docs_facts <- all_figures <- page <- figures:
a module imports only from the left. Imports are written from the root of the project.
"""
