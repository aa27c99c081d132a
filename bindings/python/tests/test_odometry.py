# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
import threading
import unittest
from collections.abc import Iterable

import numpy as np
from support import lines, needs_program, needs_simulation, program, scratch, walk

import surefoot
from surefoot import Config, Odometry, Scan, Status, Trajectory


@needs_simulation
class OdometryTest(unittest.TestCase):
    def run_scans(self, scans, *arguments, **keywords):
        odometry = Odometry(*arguments, **keywords)
        return odometry, [odometry.add_scan(scan) for scan in scans]

    def test_an_estimate_has_everything(self):
        simulation, _ = walk()
        odometry, estimates = self.run_scans(simulation)
        self.assertEqual(estimates[0].status, Status.first_scan)
        last = estimates[-1]
        self.assertTrue(last.trusted, last.message)
        self.assertEqual(last.T_world_lidar.shape, (4, 4))
        rotation = last.T_world_lidar[:3, :3]
        np.testing.assert_allclose(rotation @ rotation.T, np.eye(3), atol=1e-12)
        self.assertEqual(last.covariance.shape, (6, 6))
        self.assertTrue(np.all(np.linalg.eigvalsh(last.covariance) > 0))
        self.assertEqual(last.twist.shape, (6,))
        np.testing.assert_allclose(last.pose_at(last.stamp_ns), last.T_world_lidar, atol=1e-9)
        self.assertTrue(last.start_ns < last.stamp_ns < last.end_ns)
        self.assertGreater(last.registered_points, 100)
        self.assertIn("misfit", last.evidence)
        self.assertTrue(0.0 <= last.wrong_probability <= 1.0)
        self.assertEqual(last.segment, 0)
        self.assertEqual([stage.name for stage in last.stages], ["registration"])
        self.assertGreater(last.stages[0].matches, 100)
        points, intensities = odometry.deskewed_scan()
        self.assertEqual(points.shape, (last.points, 3))
        self.assertEqual(intensities.shape, (last.points,))
        self.assertEqual(odometry.local_map().shape[1], 3)
        side, centres = odometry.emptied_cubes()
        self.assertGreater(side, 0.0)
        self.assertEqual(centres.shape[1], 3)
        self.assertTrue(odometry.level().message)

    def test_it_finds_the_way(self):
        simulation, _ = walk()
        _, estimates = self.run_scans(simulation)
        path = Trajectory()
        for estimate in estimates:
            path.add(estimate)
        self.assertLess(surefoot.ape(simulation.truth, path).rmse, 0.02)
        for several in (simulation, path):
            self.assertIsInstance(several, Iterable)
            self.assertEqual(len(list(several)), len(several))

    @needs_program
    def test_the_program_gives_the_same_bits(self):
        _, folder = walk()
        for method in ("surefoot", "kiss-icp"):
            out = scratch("out")
            program("run", folder, "-o", out, "--method", method, "--no-report", "-q")
            path = Trajectory()
            odometry = Odometry(method)
            recording = surefoot.open(folder)
            self.assertEqual(recording.size, 12)
            for scan in recording:
                estimate = odometry.add_scan(scan)
                if estimate.trusted:
                    path.add(estimate)
            mine = scratch("mine.tum")
            surefoot.write_tum(mine, path)
            self.assertEqual(lines(mine), lines(out / "trajectory.tum"))

    def test_threads_change_nothing(self):
        simulation, _ = walk()
        maps = [self.run_scans(simulation, threads=n)[0].local_map() for n in (1, 2)]
        np.testing.assert_array_equal(maps[0], maps[1])

    def test_threads_of_python_run_beside_each_other(self):
        scans = list(walk()[0])
        expected = self.run_scans(scans)[1][-1].T_world_lidar
        results = []
        threads = [
            threading.Thread(target=lambda: results.append(self.run_scans(scans)[1][-1]))
            for _ in range(4)
        ]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(results), 4)
        for result in results:
            np.testing.assert_array_equal(result.T_world_lidar, expected)

    def test_the_lock_is_released(self):
        """While one thread registers, another one counts."""
        scans = list(walk()[0])
        done = threading.Event()
        worker = threading.Thread(target=lambda: (self.run_scans(scans), done.set()))
        worker.start()
        turns = 0
        while not done.wait(0.0005):
            turns += 1
        worker.join()
        self.assertGreater(turns, 10)

    def test_the_world_may_lie_elsewhere(self):
        simulation, _ = walk()
        T_world_start = np.eye(4)
        T_world_start[:3, :3] = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
        T_world_start[:3, 3] = [1000, 2000, 30]
        here = self.run_scans(simulation)[1][-1].T_world_lidar
        there = self.run_scans(simulation, T_world_start=T_world_start)[1][-1].T_world_lidar
        np.testing.assert_allclose(there, T_world_start @ here, atol=1e-9)
        with self.assertRaisesRegex(ValueError, "no rigid motion"):
            Odometry(T_world_start=np.full((4, 4), 2.0))

    def test_a_config_is_taken(self):
        odometry = Odometry(Config("surefoot", {"knots.points": 1234}), threads=2)
        self.assertEqual(odometry.config["knots.points"], 1234)
        self.assertEqual(Odometry("icp").config.method, "icp")
        with self.assertRaisesRegex(TypeError, "expected a Config.*got a dict"):
            Odometry({"knots.points": 1234})
        with self.assertRaisesRegex(ValueError, "threads: got 0, expected"):
            Odometry(threads=0)

    def test_arrays_outlive_what_made_them(self):
        odometry, _ = self.run_scans([walk()[0][0]])
        points, _ = odometry.deskewed_scan()
        kept = points.copy()
        del odometry
        np.testing.assert_array_equal(points, kept)
        scan = next(iter(surefoot.open(walk()[1])))
        view, kept = scan.points, scan.points.copy()
        del scan
        np.testing.assert_array_equal(view, kept)

    def test_times_out_of_order_are_rejected(self):
        simulation, _ = walk()
        odometry, _ = self.run_scans([simulation[1]])
        late = odometry.add_scan(simulation[0])
        self.assertEqual(late.status, Status.rejected)
        self.assertIn("is not after the last scan's", late.message)


if __name__ == "__main__":
    unittest.main()
