#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""What of the workflow for many machines needs no Snakemake: keys, jobs, Slurm's words.

    parts_test.py PROGRAM FOLDER-OF-THE-WORKFLOW [TEST...]
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM, FLEET = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
sys.dont_write_bytecode = True
sys.path.insert(0, str(FLEET))
import plan as planning  # noqa: E402  (where it lies is told by the caller)
import fleet  # noqa: E402
import settings as reading  # noqa: E402


class Scratch(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def write(self, name, text):
        file = self.folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        return str(file)

    def plan(self, recordings, **given):
        settings = {"command": "map", "recordings": [str(path) for path in recordings],
                    "output": str(self.folder / "out"), "options": [], "program": str(PROGRAM),
                    "retry_failed": False, "methods": [], "method": "", "vary": [], "merge": False,
                    "tiles": False}
        hashes = planning.Hashes(self.folder / "hashes.json")
        return planning.make({**settings, **given}, hashes)


class KeysTest(Scratch):
    def keys(self, recording, *options):
        return list(self.plan([recording], options=list(options))["runs"])

    def assert_part_of_the_key(self, file, recording, *options):
        before = self.keys(recording, *options)
        self.assertEqual(self.keys(recording, *options), before)
        pathlib.Path(file).write_text("another content")
        self.assertNotEqual(self.keys(recording, *options), before, file)

    def test_files_and_maps_that_options_name(self):
        walk = self.write("walk.pcap", "packets")
        for words in (["--map"], ["--localize"]):
            for name in ("campus", "campus/map.surefoot"):
                saved = self.write("campus/map.surefoot", "a map")
                self.assert_part_of_the_key(saved, walk, *words, str(self.folder / name))
                saved = self.write("campus/map.surefoot", "a map")
                self.assert_part_of_the_key(saved, walk, f"{words[0]}={self.folder / name}")

    def test_files_that_are_passed_on(self):
        walk = self.write("walk.pcap", "packets")
        stamps = self.write("stamps.txt", "0")
        self.assert_part_of_the_key(stamps, walk, f"--pass=--stamps={stamps}")
        stamps = self.write("stamps.txt", "0")
        self.assert_part_of_the_key(stamps, walk, "--pass", f"--stamps={stamps}")
        saved = self.write("run=1/map.surefoot", "a map")
        self.assert_part_of_the_key(saved, walk, "--localize", str(self.folder / "run=1"))

    def test_an_option_names_no_map_of_where_it_is_called_from(self):
        walk = self.write("walk.pcap", "packets")
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)
        before = self.keys(walk, "--no-map")
        self.write("map.surefoot", "a map")
        self.assertEqual(self.keys(walk, "--no-map"), before)

    def test_stamps_above_the_scans(self):
        self.write("sequence/velodyne/0.bin", "points")
        self.assert_part_of_the_key(self.write("sequence/times.txt", "0"),
                                    self.folder / "sequence/velodyne")

    def test_what_is_read_beside_a_recording(self):
        for walk, beside in (("walk.pcap", "walk.json"), ("walk_0000.pcap", "walk.json"),
                             ("walk.pcap.gz", "walk_meta.json"), ("walk.mcap", "gt.tum")):
            recording = self.write(walk, "packets")
            self.assert_part_of_the_key(self.write(beside, "{}"), recording)
            before = self.keys(recording)
            self.write("elsewhere.json", "{}")
            self.assertEqual(self.keys(recording), before)


class SettingsTest(Scratch):
    def read(self, **given):
        given = {"program": str(PROGRAM), "output": str(self.folder / "out"), **given}
        return reading.read(pathlib.Path(self.write("fleet.yaml", json.dumps(given))))

    def test_a_link_counts_by_its_own_name_and_neighbours(self):
        self.write("store/0001.pcap", "packets")
        link = self.folder / "walks/a.pcap"
        link.parent.mkdir()
        link.symlink_to(self.folder / "store/0001.pcap")
        self.write("walks/gt.tum", "0 0 0 0 0 0 0 1")
        settings = self.read(command="map", recordings=[str(self.folder / "store/../walks/a.pcap")])
        self.assertEqual(settings["recordings"], [str(link)])
        hashes = planning.Hashes(self.folder / "hashes.json")
        (run,) = planning.make(settings, hashes)["runs"].values()
        self.assertEqual(run["folder"], "a.pcap")
        self.assertEqual([name for name, _ in hashes.of_recording(link)[1]], ["gt.tum"])
        settings = self.read(recordings=[str(link)], methods=["icp"])
        (run,) = planning.make(settings, hashes)["runs"].values()
        self.assertEqual(run["recording"], str(link))

    def test_each_command_takes_the_pages_example(self):
        page = (FLEET.parent / "docs/fleet.md").read_text()
        example = re.search(r"```yaml\n(.*?)```", page, re.DOTALL).group(1)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)
        for walk, form in (("walks/a", "pcd"), ("walks/b.mcap", "mcap")):
            subprocess.run([PROGRAM, "simulate", "corridor", "--scans", "3", "-q", "--format", form,
                            "-o", walk], check=True)
        self.addCleanup(os.environ.update, PATH=os.environ["PATH"])
        os.environ["PATH"] = f"{PROGRAM.parent}:{os.environ['PATH']}"
        for command in reading.COMMANDS:
            own = "vary: [knots.points=1000:3000:500]\n" * (command == "sweep")
            file = self.write("fleet.yaml", own + example.replace("command: compare",
                                                               f"command: {command}"))
            plan = planning.make(reading.read(pathlib.Path(file)),
                                 planning.Hashes(self.folder / "hashes.json"))
            self.assertGreaterEqual(len(plan["runs"]), 2)
            if command not in planning.COMPARISONS:
                arguments = next(iter(plan["runs"].values()))["arguments"]
                subprocess.run([PROGRAM, *arguments, "--no-report", "--overwrite"], check=True)

    def test_what_is_wrong_is_named_in_a_line(self):
        walk = self.write("walk.pcap", "packets")
        for given, what in (({"command": ["compare"]}, "command: .*expected one of compare"),
                            ({"recordings": ["a\0b"]}, "recordings: 'a.x00b'; a text holds no NUL"),
                            ({"output": "a\0b"}, "output: 'a.x00b'")):
            with self.assertRaisesRegex(reading.SettingsError, what):
                self.read(**{"recordings": [walk], **given})
        with self.assertRaisesRegex(reading.SettingsError, "flet.yaml: there is no such file"):
            reading.read(self.folder / "flet.yaml")
        suite = self.folder / "suite"
        subprocess.run([PROGRAM, "simulate", "corridor", "--scans", "1", "-q", "-o", suite / "a"],
                       check=True)
        settings = self.read(recordings=[walk], options=[f"--suite={suite}"], methods=["icp"])
        with self.assertRaisesRegex(reading.SettingsError, "options: they add .*suite/a"):
            planning.make(settings, planning.Hashes(self.folder / "hashes.json"))

    def test_slurm_is_ours_in_one_word_or_two(self):
        self.addCleanup(os.environ.update, PATH=os.environ["PATH"])
        for words in (["--profile", "slurm"], ["--profile=slurm"]):
            call = fleet.snakemake_call("plan.json", words)
            self.assertEqual("=".join(call[-len(words):]), f"--profile={FLEET}/slurm")
            self.assertNotIn("--cores", call)

    def test_names_are_those_of_compare(self):
        walks = [self.write(name, "packets") for name in ("ä-x", "ä/ü", "ö/ü", "plain")]
        settings = self.read(recordings=walks, methods=["icp"])
        runs = planning.make(settings, planning.Hashes(self.folder / "hashes.json"))["runs"]
        names = [run["folder"].split("/")[1] for run in runs.values()]
        self.assertEqual(planning.folder_names(walks), names)


class JobsTest(Scratch):
    """A map's run, as the workflow's job does it."""

    def setUp(self):
        super().setUp()
        self.walk = self.folder / "walk"
        subprocess.run([PROGRAM, "simulate", "corridor", "--scans", "4", "-q", "-o", self.walk],
                       check=True)

    def run_job(self, count):
        """With its mark's content: what came of the run."""
        plan = self.plan([self.walk], options=["--count", str(count), "--no-report"])
        (mark,) = plan["runs"]
        (self.folder / "plan.json").write_text(json.dumps(plan))
        done = self.folder / "out/fleet/done" / mark
        done.parent.mkdir(parents=True, exist_ok=True)
        done.unlink(missing_ok=True)
        subprocess.run([sys.executable, "-B", FLEET / "work.py", self.folder / "plan.json", "run",
                        mark], check=True, stderr=subprocess.DEVNULL)
        return json.loads(done.read_text())

    def saved(self):
        return (self.folder / "out/walk/map.surefoot").read_bytes()

    def test_a_run_is_done_again_over_its_map(self):
        self.assertEqual(self.run_job(2)["outcome"], "ok")
        first = self.saved()
        again = self.run_job(4)
        self.assertEqual(again["outcome"], "ok", again)
        self.assertNotEqual(self.saved(), first)

    def test_a_run_whose_results_are_gone_is_to_be_done_again(self):
        self.run_job(2)
        plan = json.loads((self.folder / "plan.json").read_text())
        (mark,) = plan["runs"]
        done = self.folder / "out/fleet/done" / mark
        fleet.forget(plan)
        self.assertTrue(done.exists())
        (self.folder / "out/walk/map.surefoot").unlink()
        fleet.forget(plan)
        self.assertFalse(done.exists())

    def test_another_ones_map_stays(self):
        foreign = self.write("out/walk/map.surefoot", "somebody's")
        for _ in range(2):  # the fleet's own trace there makes it no fleet's
            self.assertIn("holds map.surefoot", self.run_job(2)["words"])
            self.assertEqual(pathlib.Path(foreign).read_text(), "somebody's")


class UsageTest(unittest.TestCase):
    def test_help_is_no_mistake(self):
        for words, code, where in ((["--help"], 0, "stdout"), (["-h"], 0, "stdout"),
                                   ([], 2, "stderr"), (["--nonsense"], 2, "stderr")):
            ended = subprocess.run([FLEET / "surefoot_fleet", *words], text=True,
                                   capture_output=True)
            self.assertEqual(ended.returncode, code, words)
            self.assertIn("usage: surefoot_fleet SETTINGS.yaml", getattr(ended, where), words)


class SlurmTest(Scratch):
    def status(self, scontrol, sacct=""):
        for name, script in (("scontrol", scontrol), ("sacct", sacct)):
            file = pathlib.Path(self.write(name, "#!/bin/sh\n" + script))
            file.chmod(0o755)
        path = f"{self.folder}:{os.environ['PATH']}"
        said = subprocess.run([FLEET / "slurm/slurm_status", "7"], text=True, check=True,
                              stdout=subprocess.PIPE, env=dict(os.environ, PATH=path))
        return said.stdout.strip()

    def test_failed_is_what_is_known_to_have_failed(self):
        for state, word in (("RUNNING", "running"), ("PENDING", "running"), ("STOPPED", "running"),
                            ("COMPLETED", "success"), ("FAILED", "failed"),
                            ("NODE_FAIL", "failed"), ("OUT_OF_MEMORY", "failed"),
                            ("CANCELLED", "failed")):
            line = f"echo 'JobId=7 JobName=surefoot_run JobState={state} Reason=None'"
            self.assertEqual(self.status(line), word, state)
        silent = "echo 'slurm_load_jobs error: Unable to contact slurm controller' >&2; exit 1"
        forgotten = "echo 'slurm_load_jobs error: Invalid job id specified' >&2; exit 1"
        for scontrol, sacct, word in ((silent, "", "running"), (silent, "exit 1", "running"),
                                      (silent, "echo COMPLETED", "success"),
                                      (forgotten, "", "failed"), (forgotten, "exit 1", "failed"),
                                      (forgotten, "echo COMPLETED", "success"),
                                      (forgotten, "echo CANCELLED by 1000", "failed"),
                                      (forgotten, "echo RUNNING", "running")):
            self.assertEqual(self.status(scontrol, sacct), word, (scontrol, sacct))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
