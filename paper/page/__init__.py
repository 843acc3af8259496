# SPDX-License-Identifier: MIT
"""The page of ./reproduce: the answer, the claims, and every figure and table of this machine beside the recorded ones."""
