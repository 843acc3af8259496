# SPDX-License-Identifier: MIT
"""The installed library, as projects of others use it. Usage: test_install.py BUILD [CONFIGURATION]

Installs the build into a folder of its own. CMake and pkg-config then find the library there, and every example runs.
CC and CXX choose compilers, CMAKE_GENERATOR the generator."""
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else None
CONFIGURATION = sys.argv[2] if len(sys.argv) > 2 and not sys.argv[2].startswith("-") else "Release"
del sys.argv[1:3]
CC, CXX = os.environ.get("CC", "cc"), os.environ.get("CXX", "c++")
STRICT = ["-Wall", "-Wextra", "-pedantic", "-Werror"]
VERSION = re.search(r"^version: (\S+)", (ROOT / "CITATION.cff").read_text(), re.M)[1]
PARENT = """cmake_minimum_required(VERSION 3.22)
project(parent LANGUAGES CXX)
include(FetchContent)
FetchContent_Declare(spherepair SOURCE_DIR "{root}")
FetchContent_MakeAvailable(spherepair)
add_executable(parent parent.cpp)
target_link_libraries(parent PRIVATE spherepair::spherepair)
if(CMAKE_BUILD_TYPE OR TARGET spherepair OR TARGET spherepair_tests)
  message(FATAL_ERROR "spherepair changes the build type, or builds its program or tests in another project")
endif()
"""
HIDES_EPOXY = """#define _GNU_SOURCE
#include <dlfcn.h>
#include <string.h>
void* dlopen(const char* name, int mode) {
  if (name && strstr(name, "libepoxy")) return 0;
  return ((void* (*)(const char*, int))dlsym(RTLD_NEXT, "dlopen"))(name, mode);
}
"""


def run(*words, **options):
    """Runs a command and returns its output. Raises AssertionError with the output if it fails."""
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options)
    if done.returncode:
        raise AssertionError(f"{shlex.join(map(str, words))} exits with {done.returncode}:\n{done.stdout}")
    return done.stdout


def exported(library):
    """The names that a shared library defines for others."""
    return {line.split()[-1] for line in run("nm", "-D", "--defined-only", library).splitlines()}


def declared():
    """The functions that the C headers declare."""
    headers = (ROOT / "include/spherepair").glob("*.h")
    return {name for path in headers for name in re.findall(r"^SP_API .*?\b(sp_\w+)\(", path.read_text(), re.M)}


class Install(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name).resolve()
        cls.prefix = cls.folder / "prefix"
        run("cmake", "--install", BUILD, "--config", CONFIGURATION, "--prefix", cls.prefix)
        cls.library = next(cls.prefix.rglob("libspherepair.so"))
        package = next(cls.prefix.rglob("spherepair.pc")).parent
        cls.with_package = {**os.environ, "PKG_CONFIG_PATH": str(package)}
        cls.loading = {**os.environ, "LD_LIBRARY_PATH": str(cls.library.parent)}

    def new_folder(self):
        return pathlib.Path(tempfile.mkdtemp(dir=self.folder))

    def flags(self, *which):
        return shlex.split(run("pkg-config", *which, "spherepair", env=self.with_package))

    def configure(self, text, *words):
        """Configures a project with this CMakeLists.txt and returns what CMake prints."""
        folder = self.new_folder()
        (folder / "CMakeLists.txt").write_text(text)
        (folder / "parent.cpp").write_text("#include <spherepair/spherepair.hpp>\nint main() {}\n")
        return run("cmake", "-S", folder, "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={self.prefix}", *words)

    def test_the_program_is_installed_and_runs(self):
        self.assertIn(VERSION, run(self.prefix / "bin/spherepair", "--version"))

    def test_no_file_names_the_folders_of_the_build(self):
        texts = [path for path in self.prefix.rglob("*") if path.suffix in (".cmake", ".pc", ".h", ".hpp")]
        self.assertEqual(8, len(texts))
        for path in texts:
            for folder in (BUILD, ROOT, self.prefix):
                self.assertNotIn(str(folder), path.read_text(), path)

    def test_the_library_exports_its_calls_alone(self):
        self.assertEqual(declared(), exported(self.library))

    def test_the_library_needs_nothing_but_the_compilers_libraries(self):
        needed = re.findall(r"\(NEEDED\).*\[([\w+-]+)\.so", run("readelf", "--dynamic", self.library))
        self.assertIn("libc", needed)
        allowed = {"libc", "libm", "libdl", "libpthread", "librt", "ld-linux-x86-64", "ld-linux-aarch64", "libstdc++", "libgcc_s"}
        self.assertEqual(set(), set(needed) - allowed - {"libgomp", "libomp"})

    def test_without_libepoxy_opengl_alone_is_missing(self):
        hides = self.folder / "hides.so"
        run(CC, "-shared", "-fPIC", "-x", "c", "-", "-o", hides, "-ldl", input=HIDES_EPOXY)
        environment = {**os.environ, "SPHEREPAIR_LIBRARY": str(self.library), "PYTHONPATH": str(ROOT / "python")}
        said = [run(sys.executable, "-B", "-c", "import spherepair; print(spherepair.backends())",
                    env={**environment, "LD_PRELOAD": preloaded}) for preloaded in ("", str(hides))]
        self.assertNotIn("libepoxy", said[0])
        self.assertIn("'cpu': None", said[1])
        if "opengl: not in this build" not in said[0]:
            self.assertIn("opengl: libepoxy.so.0 is missing", said[1])

    def test_another_export_is_noticed(self):
        other = self.folder / "other.so"
        run(CC, "-shared", "-fPIC", "-x", "c", "-", "-o", other, input="void sp_open(void) {} void stray(void) {}")
        self.assertEqual({"sp_open", "stray"}, exported(other))

    def test_examples_build_with_cmake_and_run(self):
        build = self.new_folder()
        run("cmake", "-S", ROOT / "examples", "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}")
        run("cmake", "--build", build, "--parallel", "2")
        said = run("ctest", "--test-dir", build, "--no-tests=error", "--verbose")
        examples = [path for path in (ROOT / "examples").iterdir() if path.suffix in (".c", ".cpp")]
        for name in ("cuda_graph", "gl_buffer"):
            if not (build / name).exists():  # no CUDA toolkit, or no libepoxy
                examples.remove(ROOT / f"examples/{name}.c")
        self.assertIn(f"0 tests failed out of {len(examples)}", said)
        self.assertIn("144 pairs", said)

    def test_the_python_example_runs_with_the_installed_library(self):
        environment = {**os.environ, "SPHEREPAIR_LIBRARY": str(self.library), "PYTHONPATH": str(ROOT / "python")}
        self.assertIn("144 pairs", run(sys.executable, "-B", ROOT / "examples/list.py", env=environment))

    def test_pkg_config_has_what_a_compiler_needs(self):
        self.assertEqual(VERSION, run("pkg-config", "--modversion", "spherepair", env=self.with_package).strip())
        for standard in ("c99", "c11"):
            program = self.folder / standard
            run(CC, f"-std={standard}", *STRICT, ROOT / "examples/list.c", "-o", program, *self.flags("--cflags", "--libs"))
            self.assertTrue(run(program, env=self.loading).startswith("144 pairs\n"))

    def test_a_strict_compiler_takes_the_cpp_header(self):
        program = self.folder / "cpp_header"
        run(CXX, "-std=c++20", *STRICT, "-Wconversion", ROOT / "tests/library/cpp_header.cpp", "-o", program,
            *self.flags("--cflags", "--libs"))
        run(program, env=self.loading)

    def test_the_page_shows_what_compiles(self):
        page = (ROOT / "docs/library.md").read_text()
        blocks = {language: re.findall(rf"^```{language}\n(.*?)^```", page, re.M | re.S) for language in ("cpp", "c")}
        (cpp, simulation, resumed), (c,) = blocks.values()
        moving = ("#include <spherepair/simulation.hpp>\nvoid show(const std::vector<double>& positions, const std::vector<double>& radii);\n"
                  "void show(const std::vector<double>& positions, const std::vector<double>& radii) {\n"
                  f"{simulation}(void)centres, (void)velocities, (void)overlaps;\n{resumed}(void)pixels;\n}}\n")
        include, body = c.split("\n", 1)
        c = f"{include}\nint fail(const char* why);\nint show(void) {{\n{body}return !i || !j; }}\n"
        for compiler, language, text in ((CXX, "c++", cpp), (CXX, "c++", moving), (CC, "c", c)):
            run(compiler, f"-std={language}{20 if language == 'c++' else 11}", *STRICT, "-fsyntax-only", "-x", language, "-",
                *self.flags("--cflags"), input=text)

    def test_the_first_page_shows_what_runs(self):
        page = (ROOT / "README.md").read_text()
        cpp, python = (re.search(rf"^```{language}\n(.*?)^```", page, re.M | re.S)[1] for language in ("cpp", "python"))
        program = self.folder / "first_page"
        run(CXX, "-std=c++20", *STRICT, "-x", "c++", "-", "-o", program, *self.flags("--cflags"), "-x", "none",
            *self.flags("--libs"), input=cpp)
        self.assertEqual("2 neighbours\n", run(program, env=self.loading))
        environment = {**os.environ, "SPHEREPAIR_LIBRARY": str(self.library), "PYTHONPATH": str(ROOT / "python")}
        self.assertEqual("4 neighbours, 1 overlap\n", run(sys.executable, "-B", "-c", python, env=environment))

    def test_another_minor_version_is_refused(self):
        major, minor, patch = map(int, VERSION.split("."))
        project = "cmake_minimum_required(VERSION 3.22)\nproject(asks LANGUAGES NONE)\nfind_package(spherepair %s REQUIRED)\n"
        self.configure(project % f"{major}.{minor}")
        self.configure(project % f"{major}.{minor}.{patch}")
        refused = [f"{major}.{minor + 1}", f"{major}.{minor}.{patch + 1}", f"{major + 1}.0"]
        for version in refused + ([f"{major}.{minor - 1}"] if major == 0 else []):
            with self.assertRaisesRegex(AssertionError, "compatible with requested", msg=version):
                self.configure(project % version)

    def test_another_project_can_take_the_sources_in(self):
        unneeded = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in ("nlohmann_json", "CLI11", "PNG", "GTest")]
        self.configure(PARENT.format(root=ROOT), "-DCMAKE_CUDA_COMPILER=NOTFOUND", *unneeded)
        with self.assertRaisesRegex(AssertionError, "its program or tests"):
            self.configure(PARENT.format(root=ROOT), "-DCMAKE_CUDA_COMPILER=NOTFOUND", "-DSPHEREPAIR_PROGRAM=ON", "-DSPHEREPAIR_TESTS=OFF")


if __name__ == "__main__":
    if BUILD is None:
        sys.exit(__doc__)
    unittest.main()
