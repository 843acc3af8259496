# SPDX-License-Identifier: MIT
"""paper/record runs each part whole or not at all, goes on with what is missing, and tells stale records; a stand-in
takes the place of the program and of the tests."""
import fcntl
import json
import os
import pathlib
import pty
import signal
import subprocess
import sys
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from changed_records import recorded  # noqa: E402  (the path must be set first)
from paper import parts, sources  # noqa: E402
from paper.numbers.suite import suite  # noqa: E402
from paper.records import DATA, Machine, Missing  # noqa: E402
from stand_ins import StandIn  # noqa: E402

# Records of the machines of paper/data that do not tell of what commit and machine they are, or not all of it, so that no
# statement is made of them; one that does is refused here. They go out when paper/record records these parts again.
REFUSED = {"h100": {"stress"}, "llvmpipe": {"stress"}}
# Records of the machines of paper/data that were made again since the kernels changed; one that is stale is refused here.
CURRENT = {"apis": {"sweep_spirv"}, "h100": set(), "h200": set(), "llvmpipe": set()}


class Recording(StandIn):
    def test_every_part_is_recorded_once_in_each_process_and_can_be_read(self):
        output = self.run_it("--processes", "3")
        self.assertNotIn("\r", output)  # no terminal
        several = {part.name for part in parts.GPU if part.processes > 1}
        self.assertEqual({"results", "sweep", "crossover", "launches"}, several)  # what ARTIFACT.md says
        calls = [words for words in self.calls() if words[0] != "run"]  # those are of the listings
        self.assertEqual(2 * len(several) + len([part for part in parts.GPU if not part.script]), len(calls))
        expected = {"results/3.json", "sweep/2/grid-1.json", "compile.json", "stress/rows-0-1.json", "state_hashes.json",
                    "tests/opengl.txt", "tests/rest-2.txt", "precision_1e8/1.json", "listings/collide_grid-opengl.txt", "counters.json"}
        self.assertLessEqual(expected, self.files())
        self.assertNotIn("precision_1e8/2.json", self.files())
        for name in self.files():
            self.assertNotRegex((self.folder / name).read_text(), f"{self.home}|{ROOT}", f"{name} has a folder of this machine")
        context = json.loads((self.folder / "results/2.json").read_text())["context"]
        self.assertEqual(["stand_in", "compare"], context["command"][:2])
        machine = Machine(self.folder)
        self.assertEqual({3, 9}, {len(record.samples_ms) for record in machine.records})  # of one process and of three
        self.assertEqual(2, len(machine.source("stress.json")["rows"]))
        self.assertIn("0 of", self.run_it("--list", "--processes", "3").splitlines()[-1])

    def test_what_is_done_is_not_repeated(self):
        self.run_it("--part", "launches", "--processes", "2")
        self.run_it("--part", "launches", "--processes", "3")
        self.assertEqual(3, len(self.calls()))
        self.run_it("--part", "launches-2")  # named, so again
        self.assertEqual(4, len(self.calls()))
        self.assertEqual({"launches/1.json", "launches/2.json", "launches/3.json"}, self.files())

    def test_a_gpu_of_ones_choice(self):
        self.run_it("--part", "launches-1", "--gpu", "1")
        self.run_it("--part", "tests-cpu", "--gpu", "1")
        self.run_it("--part", "crossover_cpu", "--gpu", "1")
        self.run_it("--part", "launches-1")
        self.assertEqual(["1", "1", "-", "-"], (self.home / "gpus.txt").read_text().split())

    def test_what_another_recording_would_disturb_has_the_host_alone(self):
        for part, held, waits in (("launches-1", fcntl.LOCK_SH, True), ("compile", fcntl.LOCK_EX, True), ("compile", fcntl.LOCK_SH, False)):
            with self.subTest(part), open(self.home / f"spherepair-recording-{os.getuid()}", "a") as lock:
                fcntl.flock(lock, held)
                before = len(self.calls())
                process = subprocess.Popen(self.words("--part", part), stdout=subprocess.PIPE, text=True, env=self.environment)
                line = process.stdout.readline()
                self.assertEqual(waits, "waits for another recording on this host" in line, line)
                self.assertEqual(0 if waits else 1, len(self.calls()) - before)
                fcntl.flock(lock, fcntl.LOCK_UN)
                with process.stdout:
                    self.assertIn("1 parts recorded, 0 failed", line + process.stdout.read())
                self.assertEqual(0, process.wait())
                self.assertEqual(1, len(self.calls()) - before)

    def test_a_sweep_is_replaced_whole(self):
        self.run_it("--part", "sweep-1")
        (self.folder / "sweep/1/grid-of-old.json").write_text("{}")
        self.run_it("--part", "sweep-1")
        self.assertEqual({"sweep/1/grid-1.json"}, self.files())

    def test_a_failed_part_leaves_nothing_and_the_others_go_on(self):
        software = {"cuda": False, "software": True}
        self.say(fails="crossover", **software)
        output = self.run_it("--processes", "1", code=1)
        self.assertIn("crossover-1 failed, exit code 3", output)
        self.assertIn("the GPU fell off the bus", output)
        self.assertFalse(any(name.startswith((".", "crossover")) for name in self.files()))
        self.assertIn("cpu_grid/1.json", self.files())
        self.say(**software)
        before = len(self.calls())
        self.run_it("--processes", "1")
        self.assertEqual({"crossover"}, {words[0] for words in self.calls()[before:]})

    def test_what_is_no_whole_record_fails(self):
        for wrong in ({"text": '{"half": '}, {"text": '{"complete": false}'}, {"verdict": "difference"},
                      {"verdict": "unfinished"}):
            self.say(**wrong)
            self.assertIn("results-1 failed, results.json", self.run_it("--part", "results-1", code=1))
            self.assertEqual(set(), self.files())

    def test_tests_that_do_not_tell_their_commit_leave_no_record(self):
        self.say(older_tests=True)
        for part, file in (("tests-opengl", "output.txt"), ("stress-0-1", "stress.json")):
            self.assertRegex(self.run_it("--part", part, code=1), f"{part} failed, {file} names no commit .* build them again")
        self.assertEqual(set(), self.files())

    def test_an_interruption_keeps_nothing_of_the_part_and_ends_the_program(self):
        self.say(sleeps=True)
        for number, stop in enumerate((signal.SIGINT, signal.SIGTERM), 1):
            with self.subTest(stop):
                self.interrupt(stop, number)

    def interrupt(self, stop, calls):
        process = subprocess.Popen(self.words("--part", "ablate-1"), stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        deadline = time.monotonic() + 30
        while len(self.calls()) < calls and time.monotonic() < deadline:
            time.sleep(0.05)
        self.assertTrue(list(self.folder.glob(".ablate-1")))
        process.send_signal(stop)
        output, _ = process.communicate(timeout=30)
        self.assertEqual(1, process.returncode)
        self.assertIn("the same command goes on", output.decode())
        self.assertEqual([], list(self.folder.iterdir()))
        with self.assertRaises(ProcessLookupError):
            os.kill(int((self.home / "calls.txt").read_text().splitlines()[-1].split()[0]), 0)

    def test_on_a_terminal_it_shows_the_time_that_passes(self):
        try:
            ours, theirs = pty.openpty()
        except OSError as reason:
            self.skipTest(f"no pseudo-terminals: {reason}")
        process = subprocess.Popen(self.words("--part", "ablate-1"), stdout=theirs, stderr=theirs)
        os.close(theirs)
        process.wait(timeout=60)
        output = os.read(ours, 10000).decode()
        os.close(ours)
        self.assertIn("\r\x1b[K[1/1] ablate-1, about 6 min ... 0.0 min", output)


class Needs(StandIn):
    def test_no_part_is_longer_than_its_bound(self):
        for part in parts.GPU + parts.SOFTWARE:
            self.assertLessEqual(part.minutes, parts.MOST_MINUTES, part.name)

    def test_what_a_gpu_is_too_small_for_is_left_out(self):
        self.say(memory=80 * 10**9)
        self.assertRegex(self.run_it("--list"), r"sweep_largest .* needs 120 GiB on the GPU, which has 74")
        self.assertIn("frames_1e9 is left out", self.run_it("--part", "frames_1e9"))
        self.assertEqual([], self.calls())

    def test_a_gpu_without_its_own_opengl_has_no_records_of_it(self):
        self.say(software=True)
        self.assertRegex(self.run_it("--list"), r"results .* needs opengl")
        self.run_it("--processes", "1")
        self.assertEqual({"crossover", "devices", "frames", "precision", "sweep"}, {words[0] for words in self.calls()})

    def test_without_cuda_there_are_other_parts(self):
        self.say(cuda=False, software=True)
        self.run_it("--processes", "1")
        self.assertEqual({part.name for part in parts.SOFTWARE if not part.tests},
                         {path.name for path in self.folder.iterdir() if path.is_dir()} - {"stress"})

    def test_what_needs_tools_that_are_absent_is_left_out(self):
        for name in ("cuobjdump", "ncu"):
            (self.home / name).unlink()
        self.environment |= {"PATH": str(self.home), "CUDA_PATH": str(self.home)}
        listed = self.run_it("--list")
        self.assertRegex(listed, r"listings .* needs cuobjdump of the CUDA toolkit")
        self.assertRegex(listed, r"counters .* needs ncu of the CUDA toolkit")

    def test_another_name_is_refused(self):
        self.assertRegex(self.run_it("--part", "abacus", code=1), "no part abacus .* but results, frame_rates")

    def test_a_program_that_is_not_there_is_named(self):
        self.assertRegex(self.run_it(program=self.home / "abacus", code=1), "abacus cannot be run .*--program names another")

    def test_a_program_of_other_sources_is_refused(self):
        self.say(digests={**sources.current(), "glsl/move": "0"})
        self.assertIn("built from other sources than these, move (GLSL): build it again", self.run_it(code=1))

    def test_earlier_records_of_the_same_parts_are_refused(self):
        for name in ("results.json", "crossover.json", "sweep/grid-64.json"):
            (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
            (self.folder / name).write_text("{}")
        self.assertIn("earlier records of the same parts, crossover.json, results.json, sweep", self.run_it(code=1))
        self.assertEqual([], self.calls())

    def test_wrong_command_lines(self):
        for words in (("--processes", "0"), ("--list", "--stale")):
            self.run_it(*words, code=2)


class Stale(StandIn):
    def test_fresh_then_touched(self):
        self.run_it("--part", "ablate-1")
        self.assertIn("0 of 1 records are stale", self.run_it("--stale"))
        path = self.folder / "ablate/1.json"
        record = json.loads(path.read_text())
        record["context"]["sources"] |= {"cuda/move": "0", "cuda/collide_grid": "0"}  # it timed one of them
        path.write_text(json.dumps(record))
        output = self.run_it("--stale", code=1)
        self.assertIn("ablate: move (CUDA); 1 of 1 timings", output)
        self.assertIn("1 of 1 records are stale", output)

    def test_without_digests_it_says_so(self):
        self.run_it("--part", "ablate")
        path = self.folder / "ablate/1.json"
        record = json.loads(path.read_text())
        del record["context"]["sources"]
        path.write_text(json.dumps(record))
        self.assertIn("ablate: recorded without digests of its sources; 1 of 1 timings", self.run_it("--stale", code=1))

    def test_a_folder_without_records_is_refused(self):
        self.assertIn("holds no records with times", self.run_it("--stale", code=1))

    def test_the_machines_of_the_paper(self):
        for machine, current in CURRENT.items():
            found = {name for name, entry in sources.checked(DATA / machine).items() if not entry.stale}
            self.assertEqual(current, found, f"{machine}: paper/record records it again")

    def test_the_machines_whose_tests_are_recorded(self):
        for name in ("h100", "llvmpipe"):
            machine, refused = recorded(name), set()
            if not all(machine.source("stress.json")["contexts"]):
                refused.add("stress")
            if (machine.folder / "tests").exists():
                try:
                    suite(machine)
                except Missing:
                    refused.add("tests")
            self.assertEqual(REFUSED.get(name, set()), refused, f"{name}: paper/record records tests-* and stress-* again")


if __name__ == "__main__":
    unittest.main()
