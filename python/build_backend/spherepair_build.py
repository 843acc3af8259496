# SPDX-License-Identifier: MIT
"""Builds the wheel (PEP 517): the Python files, and libspherepair.so beside them.

SPHEREPAIR_LIBRARY: a library to put in. Without it CMake builds one from the sources around this folder, with the
words in CMAKE_ARGS.
"""

import base64
import hashlib
import os
import pathlib
import re
import shlex
import subprocess
import sysconfig
import zipfile

PYTHON = pathlib.Path(__file__).resolve().parent.parent
ROOT = PYTHON.parent
BUILD = ROOT / "build-wheel"
METADATA = """Metadata-Version: 2.1
Name: spherepair
Version: {version}
Summary: Exact neighbour lists and sphere overlaps on the CPU, OpenGL, CUDA and Vulkan
License: MIT
Requires-Python: >=3.9
Provides-Extra: numpy
Requires-Dist: numpy; extra == "numpy"
"""


def version():
    """The version of CITATION.cff, which CMake reads, too."""
    return re.search(r"^version: *(\S+)", (ROOT / "CITATION.cff").read_text(), re.M)[1]


def library():
    """The path of the shared library, built first if none is given."""
    given = os.environ.get("SPHEREPAIR_LIBRARY")
    if given:
        if not pathlib.Path(given).is_file():
            raise SystemExit(f"SPHEREPAIR_LIBRARY is {given}: there is no such file")
        return pathlib.Path(given)
    options = ["-DCMAKE_BUILD_TYPE=Release", "-DSPHEREPAIR_PROGRAM=OFF", *shlex.split(os.environ.get("CMAKE_ARGS", ""))]
    subprocess.run(["cmake", "-S", ROOT, "-B", BUILD, *options], check=True)
    subprocess.run(["cmake", "--build", BUILD, "--target", "spherepair_shared", "--parallel"], check=True)
    found = sorted(BUILD.rglob("libspherepair.so"))
    if not found:
        raise SystemExit(f"CMake made no libspherepair.so in {BUILD}")
    return found[0]


def _record(name, data):
    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(data)}\n"


def write_wheel(path, files, info):
    """Writes the files, {name in the wheel: bytes}, and their hashes. The same input gives the same bytes."""
    record = "".join(_record(name, data) for name, data in files.items()) + f"{info}/RECORD,,\n"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as wheel:
        for name, data in {**files, f"{info}/RECORD": record.encode()}.items():
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o100755 if name.endswith(".so") else 0o100644) << 16
            wheel.writestr(entry, data)


def get_requires_for_build_wheel(config_settings=None):
    return []


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Writes the wheel into the folder. Returns its name."""
    tag = "py3-none-" + re.sub(r"[-.]", "_", sysconfig.get_platform())
    info = f"spherepair-{version()}.dist-info"
    sources = sorted(path for path in (PYTHON / "spherepair").iterdir() if path.suffix in (".py", ".typed"))
    files = {f"spherepair/{path.name}": path.read_bytes() for path in sources}
    files["spherepair/libspherepair.so"] = library().read_bytes()
    files[f"{info}/METADATA"] = METADATA.format(version=version()).encode()
    files[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: spherepair\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()
    files[f"{info}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    name = f"spherepair-{version()}-{tag}.whl"
    write_wheel(pathlib.Path(wheel_directory, name), files, info)
    return name


def build_sdist(sdist_directory, config_settings=None):
    raise SystemExit("the C++ sources are outside this folder: make a wheel, or an archive of the repository")
