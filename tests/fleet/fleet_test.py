#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""surefoot_fleet against surefoot on one machine: the same files, and nothing done twice.

    fleet_test.py PROGRAM SUREFOOT_FLEET [--profile slurm]
"""
import csv
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM, FLEET = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
MORE = sys.argv[3:] or ["--cores", "2"]
# What a run takes is not the same twice, nor is the day of a drawing. scans.csv, tables.csv and
# ablation.csv are compared without what is a time.
TIMES = ("tables.csv", "tables.md", "tables.tex", "ablation.md", "sweep.md", "compare.json",
         "ablation.json", "sweep.json", "scans.csv", "compare_run.json", "run.log", "run.yaml",
         "report.html")
TABLE_OF_TIMES = "Time and memory"
OURS = ("fleet", "tiles", "joint")  # what a fleet leaves besides
MAP = ("trajectory.tum", "trajectory_optimized.tum", "map.surefoot", "map.ply", "pose_graph.g2o")


def call(*words, folder, check=True):
    return subprocess.run([str(word) for word in words], cwd=folder, text=True, check=check,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          env=dict(os.environ, HOME=str(folder)))


def files(folder):
    """All but those of the fleet and, of a comparison, its page."""
    found = {str(file.relative_to(folder)): file
             for file in sorted(folder.rglob("*")) if file.is_file()}
    return {name: file for name, file in found.items()
            if not set(OURS) & set(file.relative_to(folder).parts) and name != "report.html"}


def rows(file):
    with file.open(newline="") as table:
        return list(csv.reader(table))


def without_times(file):
    """A table less what is a time."""
    lines = rows(file)
    if file.name == "tables.csv":
        return [line for line in lines if TABLE_OF_TIMES not in line[0]]
    kept = [k for k, name in enumerate(lines[0]) if not name.startswith("ms_")]
    return [[line[k] for k in kept] for line in lines]


class FleetTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.walks = tempfile.TemporaryDirectory()
        for seed in (1, 2):
            call(PROGRAM, "simulate", "corridor", "--seed", seed, "--scans", 12, "-q", "-o",
                 f"walk{seed}", folder=cls.walks.name)
        bad = pathlib.Path(cls.walks.name, "bad")
        bad.mkdir()
        (bad / "000000.pcd").write_text("junk")
        shutil.copy(pathlib.Path(cls.walks.name, "walk1/gt.tum"), bad)

    @classmethod
    def tearDownClass(cls):
        cls.walks.cleanup()

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        for walk in pathlib.Path(self.walks.name).iterdir():
            shutil.copytree(walk, self.folder / walk.name)

    def settings(self, **given):
        settings = {"recordings": ["walk1", "walk2"], "output": "fleet", "program": str(PROGRAM)}
        (self.folder / "fleet.yaml").write_text(json.dumps({**settings, **given}))

    def fleet(self, exit_code=0, **given):
        self.settings(**given)
        ended = call(FLEET, "fleet.yaml", *MORE, folder=self.folder, check=False)
        self.assertEqual(ended.returncode, exit_code, ended.stdout)
        return ended.stdout

    def assert_same(self, one, many):
        """Byte for byte, but for times."""
        expected, found = files(self.folder / one), files(self.folder / many)
        self.assertEqual(expected.keys(), found.keys())
        for name, file in expected.items():
            if file.name in TIMES or file.suffix == ".pdf":
                continue
            self.assertEqual(file.read_bytes(), found[name].read_bytes(), name)
        for name, file in expected.items():
            if file.name in ("scans.csv", "tables.csv"):
                self.assertEqual(without_times(file), without_times(found[name]), name)

    def test_compare_gives_what_one_machine_gives_and_does_nothing_twice(self):
        call(PROGRAM, "compare", "walk1", "walk2", "--methods", "surefoot,kiss-icp", "-o", "one",
             "-q", folder=self.folder)
        said = self.fleet(methods=["surefoot", "kiss-icp"])
        self.assert_same("one", "fleet")
        self.assertEqual(said.count("rule run:"), 4, said)
        self.assertIn("4 of 4 runs done, 0 not ok", said)
        self.assertTrue((self.folder / "fleet/report.html").exists(), said)
        self.assertEqual(len(rows(self.folder / "fleet/fleet/runs.csv")), 1 + 4)

        self.assertIn("Nothing to be done", self.fleet(methods=["surefoot", "kiss-icp"]))
        runs = sorted((self.folder / "fleet/runs").glob("*/*/*/*"))
        before = {file: file.stat().st_mtime_ns for file in runs}
        said = self.fleet(methods=["surefoot", "kiss-icp", "icp"])
        self.assertEqual(said.count("rule run:"), 2, said)
        self.assertEqual({file: file.stat().st_mtime_ns for file in runs}, before)
        self.assertEqual(len(list((self.folder / "fleet/runs").glob("*/*/*/*"))), len(runs) * 3 / 2)

    def test_ablate_and_sweep_give_what_one_machine_gives(self):
        for command, given in (("ablate", {"method": "surefoot"}),
                               ("sweep", {"vary": ["knots.segments=1:2:1", "knots.memory=0"]})):
            words = [word for key, value in given.items()
                     for each in (value if isinstance(value, list) else [value])
                     for word in (f"--{key}", each)]
            call(PROGRAM, command, "walk1", *words, "-o", f"one_{command}", "-q",
                 folder=self.folder)
            said = self.fleet(command=command, recordings=["walk1"], output=f"fleet_{command}",
                              **given)
            self.assertIn(f"fleet: {21 if command == 'ablate' else 4} of ", said)
            self.assert_same(f"one_{command}", f"fleet_{command}")

    def test_map_and_reference_give_what_one_machine_gives(self):
        shutil.copytree(self.folder / "walk2", self.folder / "other/walk1")
        walks = {"walk1": f"{self.folder.name}-walk1", "other/walk1": "other-walk1"}
        for command in ("map", "reference"):
            for walk, name in walks.items():
                call(PROGRAM, command, walk, "--set", "knots.memory=0", "-q", "-o",
                     f"one_{command}/{name}", folder=self.folder)
            self.fleet(command=command, recordings=list(walks), output=f"fleet_{command}",
                       options=["--set", "knots.memory=0"])
            self.assert_same(f"one_{command}", f"fleet_{command}")
            self.assertTrue((self.folder / f"fleet_{command}/report.html").exists())
        for name in MAP:
            self.assertTrue((self.folder / "fleet_map/other-walk1" / name).exists(), name)

    def test_maps_are_joined_and_those_that_cannot_be_are_named(self):
        for seed, scans, name in ((3101, 150, "a"), (777, 120, "b")):
            call(PROGRAM, "simulate", "campus", "--layout", 3101, "--seed", seed, "--scans", scans,
                 "--speed", 2.4, "--no-footprint", "--format", "pcap", "-q", "-o", name,
                 folder=self.folder)
        said = self.fleet(1, command="map", recordings=["a", "walk1", "b", "bad"], merge=True,
                          tiles=True, options=["--no-map", "--no-report", "--no-picture"])
        self.assertIn("walk1: not joined", said)
        self.assertIn("b: joined by", said)
        self.assertIn("bad: failed", said)
        call(PROGRAM, "merge", "fleet/a", "fleet/b", "-o", "one", folder=self.folder)
        self.assertEqual((self.folder / "fleet/joint/map.surefoot").read_bytes(),
                         (self.folder / "one/map.surefoot").read_bytes())
        self.assertTrue((self.folder / "fleet/joint/tiles/tileset.json").exists(), said)
        # Apart, each has its own.
        self.fleet(command="map", recordings=["walk1"], tiles=True, options=["--count", 10])
        self.assertTrue((self.folder / "fleet/walk1/tiles/tileset.json").exists())

    def test_what_fails_is_told_stops_nothing_and_is_tried_again_when_asked(self):
        (self.folder / "walk2/gt.tum").unlink()
        for command, failed in (("compare", 2), ("map", 1)):
            given = {"command": command, "recordings": ["bad", "walk2", "walk1"],
                     **({"methods": ["icp"]} if command == "compare" else {})}
            said = self.fleet(1, output=command, **given)
            self.assertIn(f"3 of 3 runs done, {failed} not ok", said)
            self.assertIn("none of 1 scans could be used", said)
            table = rows(self.folder / command / "fleet/runs.csv")
            self.assertEqual([line[3] for line in table[1:]],
                             ["failed", "failed" if command == "compare" else "ok", "ok"])
            self.assertIn("Nothing to be done", self.fleet(1, output=command, **given))
            said = self.fleet(1, output=command, retry_failed=True, **given)
            self.assertEqual(said.count("rule run:"), failed, said)
        self.assertTrue((self.folder / "compare/compare.json").exists())

    def test_broken_off_it_goes_on(self):
        methods = ["surefoot", "icp", "kiss-icp"]
        call(PROGRAM, "compare", "walk1", "walk2", "--methods", ",".join(methods), "-o", "one",
             "-q", folder=self.folder)
        for number in (signal.SIGINT, signal.SIGKILL):
            output = f"fleet_{number.name}"
            self.settings(methods=methods, output=output)
            done = self.folder / output / "fleet/done/runs"
            process = subprocess.Popen([str(FLEET), "fleet.yaml", *MORE], cwd=self.folder,
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                       start_new_session=True)
            while not any(file.name != "lock" for file in done.glob("*/*/1/*")):
                self.assertIsNone(process.poll())
                time.sleep(0.01)
            os.killpg(process.pid, number)
            self.assertNotEqual(process.wait(), 0)
            self.assertFalse((self.folder / output / "compare.json").exists())
            before = {file: file.read_text()  # with the time that the run took
                      for file in done.glob("*/*/1/*") if file.name != "lock"}
            said = self.fleet(methods=methods, output=output)
            self.assertIn("6 of 6 runs done, 0 not ok", said)
            self.assertEqual({file: file.read_text() for file in before}, before)
            # A cluster's jobs that end just before Ctrl-C are not known to have ended.
            again = int(re.search(r"^run +(\d+) ", said, re.M)[1])
            self.assertLess(again, 7 if "--profile" in MORE else 6)
            self.assert_same("one", output)

    def test_other_content_is_another_run(self):
        for command in ("compare", "map"):
            given = {"command": command, "recordings": ["walk1"], "output": command,
                     **({"methods": ["surefoot"]} if command == "compare" else {})}
            self.fleet(**given)
            scans = sorted((self.folder / "walk1").glob("*.pcd"))
            shutil.copyfile(scans[-1], scans[-2] if command == "map" else scans[-3])
            self.assertEqual(self.fleet(**given).count("rule run:"), 1)
            self.assertEqual(self.fleet(options=["--set", "knots.memory=0"],
                                        **given).count("rule run:"), 1)
            # What the folder held before is not there any more.
            self.assertEqual(self.fleet(**given).count("rule run:"), 1)
            # So is a file that an option names.
            (self.folder / "set.yaml").write_text("knots:\n  memory: 0.1\n")
            told = {**given, "options": ["--config=set.yaml"]}
            self.assertEqual(self.fleet(**told).count("rule run:"), 1)
            (self.folder / "set.yaml").write_text("knots:\n  memory: 0.2\n")
            self.assertEqual(self.fleet(**told).count("rule run:"), 1)
            self.assertEqual(self.fleet(**given).count("rule run:"), 1)
            if command == "map":
                shutil.rmtree(self.folder / "map/walk1")
                self.assertEqual(self.fleet(**given).count("rule run:"), 1)

    def test_two_fleets_do_not_share_an_output(self):
        self.settings()
        (self.folder / "fleet/fleet").mkdir(parents=True)
        with subprocess.Popen(["flock", "fleet/fleet/lock", "sleep", "60"],
                              cwd=self.folder, start_new_session=True) as other:
            time.sleep(0.5)
            said = self.fleet(2)
            os.killpg(other.pid, signal.SIGKILL)
        self.assertIn("another fleet is at work on it", said)

    def test_wrong_settings_are_named(self):
        for text, given in (
                ("no recordings", {"recordings": []}),
                ("walk9: no such recording", {"recordings": ["walk9"]}),
                ("walk1 is named twice", {"recordings": ["walk1", "./walk1"]}),
                ("recordings: 'walk1'; expected a list", {"recordings": "walk1"}),
                ("command: 'mapp'; expected one of compare, ablate", {"command": "mapp"}),
                ("'method' is not of compare; expected command,", {"method": "icp"}),
                ("'vary' is not of map", {"command": "map", "vary": ["a=1"]}),
                ("'recording' is unknown", {"recording": ["walk1"]}),
                ("nothing to vary", {"command": "sweep"}),
                ("--vary knots.segments: expected", {"command": "sweep",
                                                     "vary": ["knots.segments"]}),
                ("nothing is known to ablate of 'icp'", {"command": "ablate", "method": "icp"}),
                ("merge: 'yes'; expected true or false", {"command": "map", "merge": "yes"}),
                ("there is no such program: sure", {"program": "sure"}),
                ("not expected: --nonsense", {"options": ["--nonsense"]})):
            said = self.fleet(2, **given)
            self.assertIn(text, said)
            self.assertEqual(said.count("\n"), 1, said)
        for content in ("[walk1", "- walk1"):
            (self.folder / "fleet.yaml").write_text(content)
            ended = call(FLEET, "fleet.yaml", folder=self.folder, check=False)
            self.assertEqual((ended.returncode, ended.stdout.count("\n")), (2, 1), ended.stdout)

    def test_bash_completes(self):
        self.settings()
        (self.folder / "few.txt").touch()
        script = FLEET.with_name("surefoot_fleet.bash")
        for words, offered in ((("surefoot_fleet", "f"), ["fleet.yaml"]),
                               (("surefoot_fleet", "fleet.yaml", "--pro"), ["--profile"]),
                               (("surefoot_fleet", "fleet.yaml", "--profile", "s"), ["slurm"])):
            line = (f'source {script}; COMP_WORDS=({" ".join(words)}); COMP_CWORD={len(words) - 1};'
                    '_surefoot_fleet; printf "%s\\n" "${COMPREPLY[@]}"')
            said = call("bash", "--norc", "-c", line, folder=self.folder).stdout
            self.assertEqual(said.split(), offered)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
