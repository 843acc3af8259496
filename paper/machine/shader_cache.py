# SPDX-License-Identifier: MIT
"""The machine code in the shader disk cache of NVIDIA's OpenGL driver: its files hold zstd frames, these hold containers
that begin with NVuc. Behind 32 bytes stand entries of 32, each with its kind, size and place; that of kind 1 is the code."""
import ctypes
import os
import struct
import subprocess
import tempfile
from pathlib import Path

from paper.tools import Failed

FRAME = b"\x28\xb5\x2f\xfd"
CONTAINER, ENTRY, CODE = b"NVuc", 32, 1
UNKNOWN_SIZE, MOST_BYTES = 2**64 - 1, 64 * 2**20  # of what a frame holds


def zstd_library():
    try:
        library = ctypes.CDLL("libzstd.so.1")
    except OSError:
        raise Failed("the GL driver's shader cache is compressed, and libzstd.so.1 is not installed (package libzstd1)")
    library.ZSTD_getFrameContentSize.restype = ctypes.c_ulonglong
    for name in ("ZSTD_findFrameCompressedSize", "ZSTD_decompress"):
        getattr(library, name).restype = ctypes.c_size_t
    return library


def frames(raw):
    """What each zstd frame in a file holds."""
    library, at = zstd_library(), raw.find(FRAME)
    while at >= 0:
        rest = raw[at:]
        used = library.ZSTD_findFrameCompressedSize(rest, ctypes.c_size_t(len(rest)))
        size = library.ZSTD_getFrameContentSize(rest, ctypes.c_size_t(len(rest)))
        size = MOST_BYTES if size == UNKNOWN_SIZE else size
        if used <= len(rest) and size <= MOST_BYTES:  # else these bytes are no frame
            held = ctypes.create_string_buffer(size or 1)
            made = library.ZSTD_decompress(held, ctypes.c_size_t(size), rest, ctypes.c_size_t(used))
            if made <= size:
                yield held.raw[:made]
                at += used - 1
        at = raw.find(FRAME, at + 1)


def containers(folder):
    """(name of the file, bytes) of every container below a folder, each once."""
    found = {}
    for path in sorted(path for path in Path(folder).rglob("*") if path.is_file()):
        raw = path.read_bytes()
        for content in list(frames(raw)) or [raw]:
            for part in content.split(CONTAINER)[1:]:
                found.setdefault(CONTAINER + part, path.name)
    return [(name, content) for content, name in found.items()]


def code_of(container):
    """The machine code of a container; nothing where it has none."""
    for at in range(ENTRY, len(container) - ENTRY, ENTRY):
        kind, size, place = struct.unpack_from("<IIQ", container, at)
        if kind == CODE:
            return container[place:place + size] if place + size <= len(container) else b""
    return b""


def programs(folder):
    """(name of the file, machine code) of every program."""
    found = [(name, code_of(container)) for name, container in containers(folder)]
    return [(name, code) for name, code in found if code]


def compiled_by(words):
    """The programs that a command, which uses OpenGL, makes the driver compile."""
    with tempfile.TemporaryDirectory() as folder:
        cache = {"__GL_SHADER_DISK_CACHE": "1", "__GL_SHADER_DISK_CACHE_PATH": folder,
                 "__GL_SHADER_DISK_CACHE_SKIP_CLEANUP": "1"}
        made = subprocess.run(words, env={**os.environ, **cache}, capture_output=True, text=True)
        if made.returncode:
            raise Failed(f"`{' '.join(map(str, words))}` failed with exit code {made.returncode}:\n{made.stderr.strip()}")
        found = programs(folder)
        if not found:
            files = sum(path.is_file() for path in Path(folder).rglob("*"))
            raise Failed(f"none of the {files} files that `{' '.join(map(str, words))}` left in the GL driver's shader "
                             "cache holds a program: only NVIDIA's driver keeps them, and this reads those of driver 580")
        return found
