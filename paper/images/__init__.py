# SPDX-License-Identifier: MIT
"""One figure per module, as in plots, each of images that `spherepair render` has drawn."""
