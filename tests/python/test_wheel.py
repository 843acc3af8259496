# SPDX-License-Identifier: MIT
"""The wheel: what is in it, and that it installs and runs without a network."""

import base64
import hashlib
import os
import pathlib
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import unittest
import zipfile
from unittest import mock

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python/build_backend"))

import spherepair_build  # noqa: E402

LIBRARY = os.environ["SPHEREPAIR_LIBRARY"]


class Wheel(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_contents(self):
        name = spherepair_build.build_wheel(self.folder)
        tag = "py3-none-" + sysconfig.get_platform().replace("-", "_").replace(".", "_")
        self.assertEqual(f"spherepair-{spherepair_build.version()}-{tag}.whl", name)
        with zipfile.ZipFile(self.folder / name) as wheel:
            files = {entry: wheel.read(entry) for entry in wheel.namelist()}
        info = f"spherepair-{spherepair_build.version()}.dist-info"
        sources = {f"spherepair/{path.name}" for path in (ROOT / "python/spherepair").glob("*.py")}
        self.assertEqual(sources | {"spherepair/py.typed", "spherepair/libspherepair.so", f"{info}/METADATA", f"{info}/WHEEL",
                                    f"{info}/LICENSE", f"{info}/RECORD"}, set(files))
        self.assertEqual(pathlib.Path(LIBRARY).read_bytes(), files["spherepair/libspherepair.so"])
        for line in files.pop(f"{info}/RECORD").decode().splitlines()[:-1]:
            path, digest, size = line.rsplit(",", 2)
            content = files.pop(path)
            expected = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).decode().rstrip("=")
            self.assertEqual((f"sha256={expected}", str(len(content))), (digest, size))
        self.assertEqual({}, files)

    def test_equal_input_gives_equal_bytes(self):
        (self.folder / "again").mkdir()
        name = spherepair_build.build_wheel(self.folder)
        spherepair_build.build_wheel(self.folder / "again")
        self.assertEqual((self.folder / name).read_bytes(), (self.folder / "again" / name).read_bytes())

    def test_a_library_that_is_not_there(self):
        with mock.patch.dict("os.environ", SPHEREPAIR_LIBRARY="/nowhere.so"), self.assertRaisesRegex(
                SystemExit, "SPHEREPAIR_LIBRARY is /nowhere.so: there is no such file"):
            spherepair_build.build_wheel(self.folder)

    def test_cmake_is_asked_for_the_library_alone(self):
        made = self.folder / "api/libspherepair.so"
        made.parent.mkdir()
        made.write_bytes(b"a library")
        environment = {"CMAKE_ARGS": "-DSPHEREPAIR_VULKAN=OFF", "SPHEREPAIR_LIBRARY": ""}
        with mock.patch("subprocess.run") as run, mock.patch.dict("os.environ", environment), mock.patch.object(
                spherepair_build, "BUILD", self.folder):
            self.assertEqual(made, spherepair_build.library())
        configure, build = (call.args[0] for call in run.call_args_list)
        self.assertEqual(["cmake", "-S", ROOT, "-B", self.folder], configure[:5])
        self.assertIn("-DSPHEREPAIR_VULKAN=OFF", configure)
        self.assertEqual(["--target", "spherepair_shared"], build[3:5])

    def test_it_installs_without_a_network(self):
        """pip install . in a new environment; the package then finds the library beside itself."""
        if shutil.which("pip") is None and subprocess.run([sys.executable, "-m", "pip", "--version"],
                                                          capture_output=True).returncode:
            self.skipTest("pip is not installed")
        environment = self.folder / "environment"
        subprocess.run([sys.executable, "-m", "venv", "--without-pip", environment], check=True)
        subprocess.run([sys.executable, "-m", "pip", "--python", environment / "bin/python", "install", ROOT / "python",
                        "--no-build-isolation", "--no-index", "--quiet"], check=True, capture_output=True)
        code = ("import spherepair; print(spherepair.neighbor_list('ij', [[0, 0, 0], [1, 0, 0]], 2, backend='cpu')[1].tolist());"
                "print(spherepair.__file__)")
        bare = {key: value for key, value in os.environ.items() if key not in ("SPHEREPAIR_LIBRARY", "PYTHONPATH")}
        run = subprocess.run([environment / "bin/python", "-c", code], capture_output=True, text=True, env=bare, cwd=self.folder)
        self.assertEqual("[1, 0]", run.stdout.split("\n")[0], run.stderr)
        self.assertIn(str(environment), run.stdout)


if __name__ == "__main__":
    unittest.main()
