# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""The evalio pipeline against a stand-in of evalio's published interface: evalio is not here."""
import sys
import types
import unittest

import numpy as np
from support import needs_simulation, walk

import surefoot


class Stamp:
    def __init__(self, nsec):
        self.nsec = nsec

    def to_nsec(self):
        return self.nsec


class SO3:
    def __init__(self, mat):
        self.mat = np.array(mat)

    @classmethod
    def from_mat(cls, mat):
        return cls(mat)

    def to_mat(self):
        return self.mat


class OldSO3:
    """Of versions before 0.5."""

    def __init__(self, mat):
        self.mat = np.array(mat)

    @classmethod
    def fromMat(cls, mat):
        return cls(mat)

    def toMat(self):
        return self.mat


class SE3:
    def __init__(self, rot, trans):
        self.rot, self.trans = rot, np.array(trans)


class Point:
    def __init__(self, *, x=0, y=0, z=0, t=None, row=0):
        self.x, self.y, self.z, self.t, self.row = x, y, z, t, row


class LidarMeasurement:
    def __init__(self, scan):
        self.stamp = Stamp(scan.stamp_ns)
        self.scan = scan
        self.points = [
            Point(t=Stamp(int(t)), row=int(ring)) for t, ring in zip(scan.times_ns, scan.rings)
        ]

    def to_vec_positions(self):
        return self.scan.points.astype(np.float64)


class SavingPipeline:
    def __init__(self):
        self.saved = []

    def save(self, stamp, value):
        self.saved.append((stamp.to_nsec(), value))


class AskedPipeline:
    pass


def pipeline_over(base, rotation):
    """surefoot.evalio.Surefoot as a subclass of this Pipeline, with this for SO3."""
    modules = {name: types.ModuleType(name) for name in ("evalio", "evalio.pipelines", "evalio.types")}
    modules["evalio.pipelines"].Pipeline = base
    for name, kind in (("SE3", SE3), ("SO3", rotation), ("Point", Point)):
        setattr(modules["evalio.types"], name, kind)
    sys.modules.update(modules)
    sys.modules.pop("surefoot.evalio", None)
    import surefoot.evalio

    return sys.modules["surefoot.evalio"].Surefoot


@needs_simulation
class EvalioTest(unittest.TestCase):
    def run_pipeline(self, base, rotation):
        pipeline = pipeline_over(base, rotation)()
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
            pipeline.add_lidar(LidarMeasurement(scan))
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
        self.assertGreater(len(pipeline.map()["map"]), 1000)

    def test_older_versions_ask_for_the_pose(self):
        pipeline = self.run_pipeline(AskedPipeline, OldSO3)
        self.assertEqual(pipeline.pose().trans.shape, (3,))
        self.assertIsInstance(pipeline.map(), list)
        self.assertEqual(pipeline.name(), "surefoot")
        self.assertEqual(pipeline.version(), surefoot.__version__)


if __name__ == "__main__":
    unittest.main()
