# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""The evalio pipeline and data sets against a stand-in of evalio's published interface."""

import os
import types
import unittest
from unittest import mock

import numpy as np
from evalio_stand_in import (
    SE3,
    SO3,
    AskedPipeline,
    LidarMeasurement,
    OldSO3,
    Point,
    SavingPipeline,
    Stamp,
    module_over,
)
from support import SHARED_DATA, needs_program, needs_simulation, program, scratch, walk

import surefoot


def measured(scan):
    """As evalio gives it, without empty points."""
    columns = (scan.points, scan.times_ns, scan.rings)
    points = [
        Point(x=float(p[0]), y=float(p[1]), z=float(p[2]), t=Stamp(int(t)), row=int(ring))
        for p, t, ring in zip(*columns)
    ]
    return LidarMeasurement(Stamp(scan.stamp_ns), points)


@needs_simulation
class EvalioTest(unittest.TestCase):
    def run_pipeline(self, base, rotation):
        pipeline = module_over(base, rotation).Surefoot()
        default = pipeline.default_params()
        self.assertTrue(all(type(v) in (bool, int, float, str) for v in default.values()))
        self.assertEqual(pipeline.set_params({**default, "not_mine": 1}), {"not_mine": 1})
        pipeline.set_imu_params(None)
        pipeline.set_lidar_params(types.SimpleNamespace(min_range=0.1, max_range=80.0))
        pipeline.set_imu_T_lidar(SE3(rotation([[0, -1, 0], [1, 0, 0], [0, 0, 1]]), [0.1, 0.2, 0.3]))
        pipeline.initialize()
        pipeline.map()  # asked for before the first scan
        pipeline.add_imu(None)
        for scan in walk()[0]:
            pipeline.add_lidar(measured(scan))
        return pipeline

    def test_poses_are_of_the_imu_at_the_measurements_stamp(self):
        pipeline = self.run_pipeline(SavingPipeline, SO3)
        odometry = surefoot.Odometry(surefoot.Config("surefoot", {"preprocess.max_range": 80.0}))
        T_imu_lidar = np.array([[0, -1, 0, 0.1], [1, 0, 0, 0.2], [0, 0, 1, 0.3], [0, 0, 0, 1.0]])
        for scan, (stamp_ns, pose) in zip(walk()[0], pipeline.saved):
            expected = odometry.add_scan(scan).pose_at(scan.stamp_ns) @ np.linalg.inv(T_imu_lidar)
            self.assertEqual(stamp_ns, scan.stamp_ns)
            np.testing.assert_array_equal(pose.rot.to_mat(), expected[:3, :3])
            np.testing.assert_array_equal(pose.trans, expected[:3, 3])
        self.assertEqual(len(pipeline.saved), 12)
        points = [[point.x, point.y, point.z] for point in pipeline.map()["map"]]
        self.assertGreater(len(points), 500)
        np.testing.assert_array_equal(points, odometry.local_map())

    def test_older_versions_ask_for_the_pose(self):
        pipeline = self.run_pipeline(AskedPipeline, OldSO3)
        self.assertEqual(pipeline.pose().trans.shape, (3,))
        self.assertIsInstance(pipeline.map(), list)
        self.assertEqual(pipeline.name(), "surefoot")
        self.assertEqual(pipeline.version(), surefoot.__version__)


class DatasetsTest(unittest.TestCase):
    def sequences(self, folders):
        """surefoot.evalio where these folders (name of the data set: folder of recordings) are."""
        root = scratch("data")
        for name, sequences in folders.items():
            for sequence, files in sequences.items():
                (root / name / sequence).mkdir(parents=True)
                for file, target in files.items():
                    (root / name / sequence / file).symlink_to(target)
        environment = mock.patch.dict(os.environ, {"EVALIO_DATA": str(root)})
        environment.start()
        self.addCleanup(environment.stop)
        return module_over(SavingPipeline, SO3)

    def test_sequences_are_the_folders_that_are_there(self):
        evalio = self.sequences({"leg_kilo": {"corridor": {}, "park-2": {}}, "diter": {}})
        self.assertEqual([one.value for one in evalio.LegKilo], ["corridor", "park-2"])
        self.assertEqual(list(evalio.DiTer), [])
        self.assertEqual(evalio.LegKilo.dataset_name(), "leg_kilo")
        corridor = evalio.LegKilo("corridor")
        np.testing.assert_array_equal(corridor.imu_T_lidar().trans, [0, 0, 0.2])
        np.testing.assert_array_equal(corridor.imu_T_gt().trans, [0, 0, 0.2])
        with self.assertRaisesRegex(ValueError, "no truth in it, expected gt.tum"):
            corridor.ground_truth_raw()
        with self.assertRaises(surefoot.ReadError):
            list(corridor.data_iter())

    @needs_program
    @needs_simulation
    def test_a_bag_is_read_as_its_data_set_asks_for(self):
        bag = next(walk()[1].glob("*.mcap"))
        hesai = scratch("hesai.bag")
        program("convert", bag, hesai)
        evalio = self.sequences({
            "legged_recordings": {"walk": {"a.mcap": bag}}, "leg_kilo": {"walk": {"a.mcap": bag}},
            "grand_tour": {"one": {"one_hesai_points.bag": hesai, "one_imu.bag": bag}},
        })  # fmt: skip
        self.assertEqual(len(list(evalio.GrandTour("one").open())), 12)
        plain = [m.stamp.nsec for m in evalio.LeggedRecordings("walk").data_iter()]
        # Leg-KILO's stamps name a sweep's end.
        early = [m.stamp.nsec for m in evalio.LegKilo("walk").data_iter()]
        self.assertEqual(len(plain), 12)
        self.assertTrue(all(80e6 < p - e < 101e6 for p, e in zip(plain, early)))

    def test_scans_are_full_grids_in_the_order_of_rows(self):
        folder = SHARED_DATA / "gait_ramp"
        if not folder.exists():
            self.skipTest(f"{folder} is not there")
        files = {one.name: one for one in folder.iterdir()}
        evalio = self.sequences({"legged_recordings": {"ramp": files}})
        ramp = evalio.LeggedRecordings("ramp")
        params = ramp.lidar_params()
        self.assertEqual(params.num_rows, 16)
        self.assertEqual(len(ramp.data_iter()), 90)
        for scan, ours in zip(ramp.data_iter(), list(ramp.open())[:3]):
            self.assertEqual(len(scan.points), params.num_rows * params.num_columns)
            places = [(point.row, point.col) for point in scan.points]
            self.assertEqual(places, sorted(places))
            self.assertEqual(len(set(places)), len(places))
            there = [point for point in scan.points if point.range > 0]
            self.assertEqual(len(there), len(ours))
            order = np.lexsort((ours.times_ns, ours.rings))
            np.testing.assert_array_equal([(p.x, p.y, p.z) for p in there], ours.points[order])
            first = int(ours.times_ns.min())
            np.testing.assert_array_equal(
                [scan.stamp.nsec + point.t.nsec for point in there],
                ours.stamp_ns + ours.times_ns[order],
            )
            self.assertEqual(scan.stamp.nsec, ours.stamp_ns + min(first, 0))
            for row in range(params.num_rows):  # as time goes on so do columns
                columns = [point.col for point in there if point.row == row]
                self.assertEqual(columns, sorted(columns))
        truth = ramp.ground_truth_raw()
        self.assertEqual(len(truth.stamps), len(surefoot.read_tum(folder / "gt.tum")))
        np.testing.assert_array_equal(ramp.imu_T_gt().rot.mat, np.eye(3))

    def test_the_pipeline_runs_on_them_as_the_program_does(self):
        folder = SHARED_DATA / "gait_ramp"
        if not folder.exists():
            self.skipTest(f"{folder} is not there")
        evalio = self.sequences({"legged_recordings": {"ramp": {one.name: one for one in folder.iterdir()}}})
        pipeline = evalio.Surefoot()
        ramp = evalio.LeggedRecordings("ramp")
        pipeline.set_imu_T_lidar(ramp.imu_T_lidar())
        pipeline.initialize()
        odometry = surefoot.Odometry()
        for scan, ours in zip(ramp.data_iter(), list(ramp.open())[:5]):
            pipeline.add_lidar(scan)
            expected = odometry.add_scan(ours).pose_at(ours.stamp_ns)
            got = pipeline.saved[-1][1]
            np.testing.assert_allclose(got.trans, expected[:3, 3], atol=2e-3)


if __name__ == "__main__":
    unittest.main()
