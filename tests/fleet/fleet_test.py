#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""surefoot_fleet against surefoot compare: the same files, and nothing done twice.

    fleet_test.py PROGRAM SUREFOOT_FLEET [--profile slurm]
"""
import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM, FLEET = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
MORE = sys.argv[3:] or ["--cores", "2"]
# What a run takes is not the same twice: a table of compare, and columns of scans.csv.
TIMES = "Time and memory"


def call(*words, folder):
    return subprocess.run([str(word) for word in words], cwd=folder, text=True, check=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          env=dict(os.environ, HOME=str(folder))).stdout


def files(folder):
    return {str(file.relative_to(folder)): file for file in sorted(folder.glob("runs/*/*/*/*"))}


def without_times(folder):
    """tables.csv and scans.csv of all runs, less what is a time."""
    with (folder / "tables.csv").open(newline="") as table:
        rows = [row for row in csv.reader(table) if TIMES not in row[0]]
    for file in sorted(folder.glob("runs/*/*/*/scans.csv")):
        with file.open(newline="") as table:
            lines = list(csv.reader(table))
        kept = [k for k, name in enumerate(lines[0]) if not name.startswith("ms_")]
        rows += [[line[k] for k in kept] for line in lines]
    return rows


class FleetTest(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        for seed in (1, 2):
            call(PROGRAM, "simulate", "corridor", "--seed", seed, "--scans", 12, "-q", "-o",
                 f"walk{seed}", folder=self.folder)

    def fleet(self, methods, walks=("walk1", "walk2")):
        settings = {"recordings": walks, "methods": methods, "output": "fleet",
                    "program": str(PROGRAM), "options": ["--no-figures"]}
        (self.folder / "fleet.yaml").write_text(json.dumps(settings))
        return call(FLEET, "fleet.yaml", *MORE, folder=self.folder)

    def test_it_gives_what_one_machine_gives_and_does_nothing_twice(self):
        call(PROGRAM, "compare", "walk1", "walk2", "--methods", "surefoot,kiss-icp", "-o", "one",
             "--no-figures", "-q", folder=self.folder)
        said = self.fleet(["surefoot", "kiss-icp"])
        one, many = files(self.folder / "one"), files(self.folder / "fleet")
        self.assertEqual(one.keys(), many.keys(), said)
        same = [name for name in one if name.endswith((".tum", "kitti.txt", ".ply"))]
        self.assertEqual(len(same), 4 * 4)
        for name in same:
            self.assertEqual(one[name].read_bytes(), many[name].read_bytes(), name)
        self.assertEqual(without_times(self.folder / "one"), without_times(self.folder / "fleet"))
        self.assertTrue((self.folder / "fleet/report.html").exists(), said)

        self.assertIn("Nothing to be done", self.fleet(["surefoot", "kiss-icp"]))
        before = {name: file.stat().st_mtime_ns for name, file in many.items()}
        said = self.fleet(["surefoot", "kiss-icp", "icp"])
        self.assertEqual(said.count("rule run:"), 2, said)
        after = files(self.folder / "fleet")
        self.assertEqual(len(after), len(before) * 3 // 2)
        self.assertEqual({name: after[name].stat().st_mtime_ns for name in before}, before)

    def test_other_content_is_another_run(self):
        self.fleet(["icp"], ["walk1"])
        scan = sorted((self.folder / "walk1").glob("*.pcd"))[-1]
        scan.write_bytes(scan.read_bytes()[:-16])
        self.assertEqual(self.fleet(["icp"], ["walk1"]).count("rule run:"), 1)

    def test_what_is_missing_is_named(self):
        for walks, text in (([], "no recordings"), (["walk9"], "no such recording")):
            with self.assertRaises(subprocess.CalledProcessError) as error:
                self.fleet(["icp"], walks)
            self.assertIn(text, error.exception.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
