# SPDX-License-Identifier: MIT
"""NVIDIA's tools, which a machine with the CUDA toolkit has."""
import os
import shutil
import subprocess

BESIDE_NVCC = os.environ.get("CUDA_PATH", "/usr/local/cuda") + "/bin"


class Failed(Exception):
    """What failed, where, and what to do."""


def path_of(name):
    return shutil.which(name) or shutil.which(name, path=BESIDE_NVCC)


def required(name):
    path = path_of(name)
    if not path:
        raise Failed(f"{name} is neither in PATH nor in {BESIDE_NVCC}: it is part of the CUDA toolkit")
    return path


def output_of(name, *words):
    """What a tool prints."""
    made = subprocess.run([required(name), *map(str, words)], capture_output=True, text=True)
    if made.returncode:
        raise Failed(f"{name} {' '.join(map(str, words))} failed with exit code {made.returncode}:\n"
                     f"{(made.stderr or made.stdout).strip()}")
    return made.stdout


def version_of(name):
    """The last line that has a version."""
    lines = output_of(name, "--version").strip().splitlines()
    return next((line.strip() for line in reversed(lines) if "ersion" in line or "release" in line), "")
