# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
import re
import signal
import sys
import threading
import unittest

import numpy as np
from support import SOURCES, lines, needs_program, needs_simulation, program, scratch, walk

import surefoot


@needs_simulation
class RunTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.simulation, cls.folder = walk()
        cls.said = []
        cls.run_made = surefoot.run(
            cls.folder,
            scratch("run"),
            config=surefoot.Config("surefoot", {"knots.points": 1500}),
            count=10,
            no_picture=True,
            no_report=True,
            say=cls.said.append,
        )

    def test_it_is_read_back(self):
        run = self.run_made
        self.assertEqual(run.method, "surefoot")
        self.assertEqual(len(run.scans["stamp_ns"]), 10)
        self.assertEqual(run.scans["status"][0], "first_scan")
        self.assertEqual(len(run.trajectory), 10)
        self.assertGreater(len(run.map_points), 1000)
        self.assertEqual(run.parameters["knots.points"], "1500")
        self.assertEqual(run.input, self.folder.resolve())
        np.testing.assert_array_equal(surefoot.read_run(run.folder).map_points, run.map_points)
        error = surefoot.ape(self.simulation.truth, run.trajectory, align="origin")
        self.assertLess(error.rmse, 0.02)

    @needs_program
    def test_the_program_leaves_the_same_files(self):
        out = scratch("out")
        options = ("--set", "knots.points=1500", "--count", 10, "--no-report", "--no-picture", "-q")
        program("run", self.folder, "-o", out, *options)
        for name in ("trajectory.tum", "trajectory_kitti.txt", "map.ply", "run.yaml"):
            self.assertEqual(
                (out / name).read_bytes(), (self.run_made.folder / name).read_bytes(), name
            )

    @needs_program
    def test_its_picture_shows_the_truth_that_is_given(self):
        truth = scratch("truth.tum")
        rows = np.loadtxt(self.folder / "gt.tum")
        rows[:, 3] += 0.3 * np.sin(np.arange(len(rows)))
        np.savetxt(truth, rows, fmt="%.9f")
        options = {"count": 10, "no_report": True}
        beside = surefoot.run(self.folder, scratch("beside"), **options).folder
        given = surefoot.run(self.folder, scratch("given"), truth=truth, **options).folder
        out = scratch("out")
        program("run", self.folder, "-o", out, "--truth", truth, "--count", 10, "--no-report", "-q")
        drawn = (given / "picture.png").read_bytes()
        self.assertTrue(drawn == (out / "picture.png").read_bytes())
        self.assertFalse(drawn == (beside / "picture.png").read_bytes())

    @needs_program
    def test_the_program_repeats_it(self):
        out = scratch("again")
        program("run", "--config", self.run_made.folder / "run.yaml", "-o", out, "-q")
        self.assertEqual(
            (out / "map.ply").read_bytes(), (self.run_made.folder / "map.ply").read_bytes()
        )

    @needs_program
    def test_a_run_of_the_program_is_read(self):
        out = scratch("theirs")
        program("run", self.folder, "-o", out, "-q", "--method", "icp")
        self.assertEqual(surefoot.read_run(out).method, "icp")

    @needs_program
    def test_maps_are_made_and_come_back_to(self):
        saved, out = scratch("saved"), scratch("out")
        program("map", self.folder, "-o", saved, "-q", "--no-report")
        options = {"no_report": True, "no_picture": True}
        closed = surefoot.run(self.folder, scratch("closed"), loop_closure=True, **options).folder
        self.assertIn("loop-closure: true", (closed / "run.yaml").read_text())
        name = "trajectory_optimized.tum"
        self.assertEqual(lines(closed / name), lines(saved / name))
        there = surefoot.run(self.folder, out, localize=saved, truth=None, **options).folder
        self.assertTrue((there / "localization.csv").exists())
        joined = surefoot.run(self.folder, scratch("joined"), map=saved, **options)
        # Too short to be joined.
        self.assertTrue(any("saved is not continued" in note for note in joined.notes), joined.notes)

    def test_options_are_checked(self):
        for options, what in (
            ({"colour": 1}, "run\\(\\) has no option 'colour'; it has: config, .*pose_rate.*, topic"),
            ({"count": "x"}, "count: got 'x'"),
            ({"count": 0}, "expected at least 1"),
            ({"map_voxel": 0.0}, "map_voxel: expected"),
            ({"extrinsic": [1, 2]}, "extrinsic: expected x y z"),
            ({"config": "fast"}, "fast"),
            ({"config": {"knots.points": 1}}, "config: expected a Config.*got a dict"),
            ({"rate": 0}, "rate: got 0, expected 0.001 .. 10000"),
            ({"loop_closure": "x"}, "loop_closure: got 'x'"),
        ):
            with self.assertRaisesRegex((TypeError, ValueError), what):
                surefoot.run(self.folder, scratch("none"), **options)

    @needs_program
    def test_every_option_of_the_program_is_taken_or_named_on_the_page(self):
        given = set(re.findall(r"^ +(?:-\w,)?--([a-z0-9-]+)", program("run", "--help"), re.MULTILINE))
        self.assertGreater(len(given), 40)
        with self.assertRaises(TypeError) as refused:
            surefoot.run(self.folder, colour=1)
        taken = str(refused.exception).split("it has: ")[1].replace("_", "-").split(", ")
        page = (SOURCES / "docs" / "python.md").read_text()
        (row,) = (line for line in page.splitlines() if line.startswith("| `run("))
        named = re.findall(r"`--([a-z-]+)`", row)
        self.assertEqual(set(named) - given, set(), "named on the page, unknown to the program")
        self.assertEqual(given - {"help", *taken, *named}, set(), "neither taken nor named")

    def test_an_error_of_a_listener_arrives_when_all_is_written(self):
        def fail(*_):
            raise KeyError("mine")

        for listener in ("say", "progress"):
            out = scratch("failed")
            with self.assertRaisesRegex(KeyError, "mine"):
                surefoot.run(self.folder, out, level="none", **{listener: fail})
            if listener == "progress":
                self.check_ended(out, 1)

    def test_ctrl_c_ends_it_with_whole_files(self):
        out = scratch("stopped")

        def stop(scans, share):
            if scans == 3:
                signal.raise_signal(signal.SIGINT)

        with self.assertRaises(KeyboardInterrupt):
            surefoot.run(self.folder, out, progress=stop)
        self.check_ended(out, 3)

    def check_ended(self, out, scans):
        run = surefoot.read_run(out)
        self.assertEqual(len(run.scans["stamp_ns"]), scans)
        self.assertGreater(len(run.map_points), 1000)
        for name in ("run.yaml", "map.ply", "picture.png", "report.html"):
            self.assertTrue((out / name).exists(), name)

    def test_scans_are_a_table_of_pandas(self):
        try:
            import pandas
        except ImportError:
            self.skipTest("no pandas here")
        table = pandas.DataFrame(self.run_made.scans)
        self.assertEqual(len(table), 10)
        self.assertEqual(set(table.status), {"first_scan", "ok"})
        self.assertGreater(table.points.min(), 1000)

    def test_a_notebook_shows_what_came_of_it(self):
        shown = self.run_made._repr_html_()
        for row in ("<th>scans</th><td>10</td>", "<th>first_scan</th><td>1</td>", "<th>method</th><td>surefoot</td>"):
            self.assertIn(row, shown)

    def test_a_plot_is_drawn(self):
        try:
            import matplotlib
        except ImportError:
            self.skipTest("no matplotlib here")
        matplotlib.use("Agg")
        figure = self.run_made.plot(truth=self.simulation.truth)
        self.assertEqual(len(figure.axes), 2)


@needs_simulation
class EvaluationTest(unittest.TestCase):
    def trajectory(self, *shifts):
        path = surefoot.Trajectory()
        for i, shift in enumerate(shifts):
            pose = np.eye(4)
            pose[:3, 3] = [i, 0.1 * i * i + shift, 0]
            path.append(i * 100_000_000, pose)
        return path

    def test_errors_are_what_they_are(self):
        truth = self.trajectory(0, 0, 0, 0, 0)
        errors = surefoot.ape(truth, self.trajectory(0, 0, 0.3, 0, 0.4), align="none")
        np.testing.assert_allclose(errors.errors, [0, 0, 0.3, 0, 0.4], atol=1e-12)
        self.assertAlmostEqual(errors.rmse, np.sqrt(0.25 / 5))
        self.assertAlmostEqual(errors.max, 0.4)
        self.assertEqual(errors.unit, "m")
        self.assertEqual(len(errors.stamps_ns), 5)
        relative = surefoot.rpe(truth, self.trajectory(0, 0, 0.3, 0.3, 0.3))
        np.testing.assert_allclose(relative.errors, [0, 0.3, 0, 0], atol=1e-12)

    def test_stamps_that_are_no_nanoseconds_are_refused(self):
        poses = np.tile(np.eye(4), (2, 1, 1))
        for stamps, what in (
            ([0.0, 0.1], "stamps_ns: got 0.1, expected whole numbers"),
            ([0.0, np.nan], "stamps_ns: got nan to nan, expected"),
            (np.array([0, 2**64 - 1], np.uint64), "stamps_ns: got 0 to 18446744073709551615"),
            ([0.0, 2.0**63], "stamps_ns: got 0.0 to 9.2.*, expected"),
            (np.array([0, 1], "M8[ns]"), "expected numbers"),
        ):
            with self.assertRaisesRegex(ValueError, what):
                surefoot.Trajectory(stamps, poses)
        whole = surefoot.Trajectory([0.0, 1e9], poses).stamps_ns
        np.testing.assert_array_equal(whole, [0, 1_000_000_000])

    def test_a_trajectory_may_grow_meanwhile(self):
        """While it is copied to a larger place, too, which happens at powers of two."""
        self.addCleanup(sys.setswitchinterval, sys.getswitchinterval())
        sys.setswitchinterval(1e-5)

        def look(growing, done):
            while not done.is_set():
                surefoot.ape(growing, growing, align="none")

        stamps, pose = np.arange(40000) * 10**8, np.eye(4)
        for size in [2**k - 1000 for k in (12, 13, 14, 15)] * 2:
            growing = surefoot.Trajectory(stamps[:size], np.tile(pose, (size, 1, 1)))
            done = threading.Event()
            looker = threading.Thread(target=look, args=(growing, done))
            looker.start()
            for stamp in stamps[size : size + 3000]:
                growing.append(int(stamp), pose)
            done.set()
            looker.join()
            self.assertEqual(len(growing), size + 3000)

    def test_an_alignment_is_found(self):
        truth = self.trajectory(0, 0, 0, 0, 0)
        moved = surefoot.Trajectory(truth.stamps_ns, truth.poses + np.eye(4, k=3) * 5)
        errors = surefoot.ape(truth, moved)
        self.assertLess(errors.max, 1e-12)
        np.testing.assert_allclose(errors.T_reference_estimate[:3, 3], [-5, 0, 0], atol=1e-9)

    @needs_program
    def test_the_program_says_the_same(self):
        simulation, folder = walk()
        run = surefoot.run(folder, scratch("run"), no_report=True, no_map=True)
        import json

        theirs = json.loads(program("eval", folder, run.folder, "--json"))[0]
        mine = surefoot.evaluate(surefoot.read_tum(folder / "gt.tum"), run.trajectory)
        self.assertEqual(theirs.pop("estimate"), "run")
        self.assertEqual(mine.pop("estimate"), "estimate")
        self.assertEqual(mine, theirs)

    def test_bad_input_says_what_was_expected(self):
        truth = self.trajectory(0, 0, 0)
        with self.assertRaisesRegex(ValueError, "align: got 'best', expected one of: none"):
            surefoot.ape(truth, truth, align="best")
        with self.assertRaisesRegex(ValueError, "no poses"):
            surefoot.ape(truth, surefoot.Trajectory())
        with self.assertRaisesRegex(ValueError, r"expected \(N,\) and \(N, 4, 4\)"):
            surefoot.Trajectory([1, 2], np.eye(4))
        with self.assertRaisesRegex(surefoot.ReadError, "line 1"):
            file = scratch("bad.tum")
            file.write_text("1 2 3\n")
            surefoot.read_tum(file)
        with self.assertRaises(IndexError):
            truth[3]
        self.assertEqual(truth[-1][0], 200_000_000)


@needs_simulation
class SimulationTest(unittest.TestCase):
    def test_scans_can_be_asked_for_in_any_order(self):
        simulation, _ = walk()
        self.assertEqual(len(simulation), 12)
        np.testing.assert_array_equal(simulation[-1].points, list(simulation)[11].points)
        with self.assertRaises(IndexError):
            simulation[12]
        self.assertIn("corridor", surefoot.scenes())
        self.assertGreater(len(simulation.truth), 400)

    @needs_program
    def test_the_program_makes_the_same(self):
        _, folder = walk()
        theirs = scratch("theirs")
        program("simulate", "corridor", "--scans", 3, "--no-footprint", "-o", theirs, "-q")
        self.assertEqual(
            (theirs / "000002.pcd").read_bytes(), (folder / "000002.pcd").read_bytes()
        )

    def test_requests_are_checked(self):
        with self.assertRaisesRegex(ValueError, "moon"):
            surefoot.simulate("moon")
        nan = float("nan")
        for options, what in (
            ({"scans": 0}, "scans: got 0, expected 1 .. 100000"),
            ({"speed": -1}, "speed: got -1, expected 0.3 .. 5"),
            ({"speed": nan}, "speed: got nan"),
            ({"gait_scale": nan}, "gait_scale: got nan, expected 0 .. 10"),
            ({"people": 100000}, "people: got 100000, expected 0 .. 20"),
            ({"rain": 2}, "rain: got 2, expected 0 .. 0.5"),
            ({"dust": nan}, "dust: got nan, expected 0 .. 0.5"),
        ):
            with self.assertRaisesRegex(ValueError, what):
                surefoot.simulate("corridor", **{"scans": 1, **options})
        with self.assertRaisesRegex(ValueError, "formats: got 'las', expected one of: pcd"):
            walk()[0].write(scratch("x"), ["las"])


if __name__ == "__main__":
    unittest.main()
