# SPDX-License-Identifier: MIT
"""Digests of what is timed: they follow the sources, and records say when theirs are others. The program takes the
command lines of a recording.
Usage: test_sources.py SPHEREPAIR"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))
PROGRAM = sys.argv.pop(1)

from paper import parts, sources  # noqa: E402  (the path must be set first)

FOLDERS = ("common", "shaders", "cuda", "glsl", "vulkan", "interop", "bench/measure")


class Tree(unittest.TestCase):
    """A copy of the sources, in which files change."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name, "tree")
        for name in FOLDERS:
            shutil.copytree(ROOT / name, self.root / name)

    def append(self, file, text):
        path = self.root / file
        path.write_text(path.read_text() + text)
        sources.current.cache_clear()

    def changed(self, file, text):
        """The names whose digests are others after the change."""
        before = sources.current(self.root)
        self.append(file, text)
        after = sources.current(self.root)
        self.assertEqual(before.keys(), after.keys())
        return {name for name in before if before[name] != after[name]}


class Digests(Tree):
    def test_the_folder_does_not_matter(self):
        self.assertEqual(sources.current(ROOT), sources.current(self.root))

    def test_every_kernel_has_one_in_each_api_that_has_it(self):
        names = sources.current(ROOT).keys()
        self.assertLessEqual({"host/cpu", "host/glsl", "host/cuda", "host/vulkan", "measure", "glsl/mesh.vert"}, names)
        kernels = [{name.split("/")[1] for name in names if name.startswith(api) and "." not in name}
                   for api in ("glsl/", "cuda/")]
        of_cuda = re.search(r"SPHEREPAIR_CUDA_KERNELS\(each\)(.*?)\n#define", (ROOT / "common/device/kernel_list.h").read_text(),
                            re.DOTALL)[1]
        self.assertEqual(kernels[0] | set(re.findall(r"each\((\w+)", of_cuda)), kernels[1])
        self.assertLess(40, len(kernels[0]))

    def test_a_kernel_counts_in_its_api(self):
        self.assertEqual({"glsl/collide_grid"}, self.changed("shaders/collide/collide_grid.comp", "uint unused;\n"))
        self.assertEqual({"cuda/collide_grid"}, self.changed("cuda/collide/collide_grid.cu", "// one\nint unused;\n"))

    def test_what_it_includes_counts_too(self):
        found = self.changed("common/shared/exact.h", "int unused;\n")  # some include it through collide.glsl and .cuh
        self.assertLessEqual({"glsl/collide_grid", "cuda/collide_grid", "glsl/decide", "host/cpu"}, found)
        self.assertFalse(found & {"glsl/peak_copy", "cuda/peak_copy", "host/glsl", "host/cuda", "measure"})
        self.assertEqual({"host/contacts", "glsl/collide_swept", "cuda/collide_swept"}, self.changed("common/shared/swept.h", "int unused;\n"))

    def test_host_paths(self):
        every = {"host/glsl", "host/cuda", "host/vulkan"}
        for file, names in (("common/simulation/search/pair_search.cpp", every), ("glsl/gl_device.cpp", {"host/glsl"}),
                            ("common/glsl/kernel_text.cpp", {"host/glsl", "host/vulkan"}), ("vulkan/launches.cpp", {"host/vulkan"}),
                            ("cuda/host/cuda_device.cpp", {"host/cuda"}), ("bench/measure/timing.cpp", {"measure"}),
                            ("common/cpu/search/cpu_simd.cpp", {"host/cpu"}),
                            ("common/cpu/cpu_contacts.cpp", {"host/contacts"}),
                            ("common/simulation/search/near_pairs.cpp", {"host/contacts"}),
                            ("common/backend/swept_paths.cpp", {"host/contacts"}), ("common/backend/crossover.h", set())):
            self.assertEqual(names, self.changed(file, "int unused;\n"), file)
        found = self.changed("common/shared/contact/fixed.h", "int unused;\n")
        self.assertLessEqual({"host/contacts", "glsl/leapfrog", "cuda/leapfrog"}, found)
        self.assertFalse(found & {"host/cpu", "host/glsl", "host/cuda"})

    def test_comments_includes_and_white_space_do_not(self):
        self.assertEqual(set(), self.changed("shaders/collide/collide_grid.comp", "  // a comment\n\n\n"))
        self.assertEqual(set(), self.changed("common/scene/scene.cpp", '#include "common/scene/counted.h"\n'))

    def test_what_stands_behind_a_division_counts(self):
        for file, name in (("shaders/collide/collide_grid.comp", "glsl/collide_grid"), ("glsl/gl_device.cpp", "host/glsl")):
            self.append(file, "float unused = 1.0f /")
            self.assertEqual({name}, self.changed(file, " 2.0f;\n"), file)

    def test_a_missing_include_is_named(self):
        self.append("cuda/collide/clear.cu", '#include "cuda/collide/abacus.cuh"\n')
        with self.assertRaisesRegex(sources.Unknown, "abacus.cuh"):
            sources.current(self.root)

    def test_a_room_that_is_gone_is_named(self):
        shutil.rmtree(self.root / "common/simulation")
        with self.assertRaisesRegex(sources.Unknown, "no room common/simulation"):
            sources.current(self.root)

    def test_the_program_has_those_of_the_tree(self):
        made = subprocess.run([PROGRAM, "devices", "--backends", "cpu", "--json", "-"], capture_output=True, text=True)
        record, _ = json.JSONDecoder().raw_decode(made.stdout[made.stdout.index("{"):])
        self.assertEqual(sources.current(ROOT), record["context"]["sources"])


def timing(backend, **stages):
    return {"backend": backend, "samples_ms": [1.0], "device_stages_ms": stages}


class Stale(Tree):
    def record(self, name, rows, context=None):
        path = self.root.parent / "machine" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps({"context": context or {"sources": sources.current(self.root)},
                                    "measurements": rows}))

    def stale(self):
        """name -> (what has changed, stale timings, all timings), of what is stale."""
        found = sources.checked(self.root.parent / "machine", self.root)
        self.assertTrue(found)
        return {name: (", ".join(sources.parts(entry.changed)), entry.stale, entry.timings)
                for name, entry in found.items() if entry.stale}

    def test_fresh_then_touched(self):
        self.record("a.json", [timing("cuda", collide_grid=1), timing("cuda", move=1), timing("opengl", collide_grid=1)])
        self.record("core.json", [timing("opengl-core", draw_cull_far=1)])
        self.record("sweep/1/b.json", [timing("opengl", draw_cull_far=1)])
        self.record("sweep/2/b.json", [timing("opengl", draw_cull_far=1)])
        self.assertEqual({}, self.stale())
        self.append("cuda/collide/collide_grid.cu", "int unused;\n")
        self.assertEqual({"a.json": ("collide_grid (CUDA)", 1, 3)}, self.stale())
        self.append("shaders/draw/draw_cull.comp", "int unused;\n")
        self.assertEqual(("draw_cull (GLSL)", 2, 2), self.stale()["sweep"])
        self.assertEqual(("draw_cull (GLSL)", 1, 1), self.stale()["core.json"])

    def test_the_way_of_measuring_counts_for_all(self):
        self.record("a.json", [timing("cpu"), timing("cuda", move=1)])
        self.append("bench/measure/timing.cpp", "int unused;\n")
        self.assertEqual({"a.json": ("timing", 2, 2)}, self.stale())

    def test_contacts_count_where_they_are(self):
        self.record("a.json", [timing("cuda", contact_pairs=1, leapfrog=1), timing("cuda", move=1), timing("cpu"),
                               {**timing("cpu"), "sums": "integers"}])
        self.append("common/cpu/cpu_contacts.cpp", "int unused;\n")
        self.assertEqual({"a.json": ("host code of contacts", 2, 4)}, self.stale())

    def test_without_device_timers_every_kernel_of_the_api_counts(self):
        self.record("a.json", [timing("opengl"), timing("cpu"), timing("cuda")])
        self.append("shaders/draw/draw_cull.comp", "int unused;\n")
        self.assertEqual({"a.json": ("draw_cull (GLSL)", 1, 3)}, self.stale())

    def test_without_device_timers_kernels_of_contacts_count_where_these_may_be_timed(self):
        self.record("a.json", [timing("opengl"), {**timing("opengl"), "sums": "integers"}, {**timing("opengl"), "option": "order"},
                               {**timing("opengl"), "sphere_steps_per_second": 1e10}])
        self.append("shaders/contact/leapfrog.comp", "int unused;\n")
        self.assertEqual({"a.json": ("leapfrog (GLSL)", 3, 4)}, self.stale())

    def test_listings_and_counters_are_of_one_kernel(self):
        self.record("listings/listings.json", [{"kernel": "collide_grid", "backend": "opengl"}, {"kernel": "move", "backend": "cuda"}],
                    context={"kernel": "Linux", "sources": sources.current(self.root)})
        self.append("bench/measure/timing.cpp", "int unused;\n")
        self.append("glsl/gl_device.cpp", "int unused;\n")
        self.assertEqual({}, self.stale())
        self.append("shaders/collide/collide_grid.comp", "int unused;\n")
        self.assertEqual({"listings": ("collide_grid (GLSL)", 1, 2)}, self.stale())

    def test_what_opengl_draws_counts_for_either_api(self):
        self.record("a.json", [{**timing("cuda", move=1), "draw": "points"}])
        self.append("shaders/draw/points.vert", "int unused;\n")
        self.assertEqual({"a.json": ("points (GLSL)", 1, 1)}, self.stale())

    def test_without_digests_it_is_stale(self):
        self.record("a.json", [timing("cpu")], context={"build": {}})
        self.assertEqual({"a.json": ("", 1, 1)}, self.stale())
        self.assertTrue(sources.checked(self.root.parent / "machine", self.root)["a.json"].without_digests)

    def test_under_a_figure_the_first_are_named(self):
        now, row = sources.current(ROOT), {"backend": "opengl"}
        earlier = {name: "0" if name.startswith("glsl/peak") or name == "measure" else now[name] for name in now}
        self.assertEqual("", sources.note([(row, now)]))
        self.assertEqual("recorded with earlier peak_atomics (GLSL), peak_copy (GLSL), peak_issue (GLSL), peak_words "
                         "(GLSL) and 1 more; recorded without digests of its kernels",
                         sources.note([(row, earlier), (row, None)]))

    def test_a_kernel_that_is_gone_has_changed(self):
        self.record("a.json", [timing("opengl", points=1)])
        (self.root / "shaders/draw/points.frag").unlink()
        sources.current.cache_clear()
        self.assertEqual({"a.json": ("points (GLSL)", 1, 1)}, self.stale())


class Parts(unittest.TestCase):
    def test_the_program_takes_their_command_lines(self):
        """All it may refuse as wrong usage is the folder of the records, below a file."""
        for run in parts.runs([part for part in parts.GPU + parts.SOFTWARE if not part.tests and not part.script], 1):
            with self.subTest(run.name):
                made = subprocess.run([PROGRAM, *run.command(__file__)[0]], capture_output=True, text=True)
                self.assertNotEqual(0, made.returncode)
                if made.returncode == 2:
                    self.assertRegex(made.stderr, f"cannot (create the folder|write) {__file__}")


if __name__ == "__main__":
    unittest.main()
