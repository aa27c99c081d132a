# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
import unittest

import numpy as np
from support import needs_simulation, scratch

import surefoot
from surefoot import Localizer, Mapper, Odometry


@needs_simulation
class MappingTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.walk = surefoot.simulate("campus", scans=60, speed=2.4, footprint=False)
        cls.mapper = Mapper()
        cls.estimates = []
        odometry = Odometry()
        for scan in cls.walk:
            estimate = odometry.add_scan(scan)
            cls.mapper.add(estimate, odometry.deskewed_scan()[0])
            cls.estimates.append(estimate)
        cls.mapper.finish()
        cls.file = scratch("map.surefoot")
        cls.mapper.save(cls.file)

    def test_a_walk_that_never_returned_is_the_odometrys(self):
        trajectory = self.mapper.trajectory()
        trusted = [e for e in self.estimates if e.trusted]
        self.assertEqual(len(trajectory), len(trusted))
        np.testing.assert_allclose(
            trajectory.poses, [e.T_world_lidar for e in trusted], atol=1e-9
        )
        self.assertEqual(self.mapper.loops, 0)
        self.assertGreaterEqual(self.mapper.compared, 0)
        np.testing.assert_allclose(
            self.mapper.T_map_world(trusted[5].stamp_ns), np.eye(4), atol=1e-9
        )

    def test_the_map_is_found_again(self):
        localizer = Localizer(self.file)
        self.assertIsNone(localizer.T_map_lidar)
        odometry = Odometry()
        for i, scan in enumerate(self.walk):
            if i < 5:
                continue
            localizer.add(odometry.add_scan(scan), odometry.deskewed_scan()[0])
        self.assertIsNotNone(localizer.T_map_lidar, localizer.message)
        self.assertEqual(localizer.T_map_world.shape, (4, 4))
        off = localizer.T_map_lidar[:3, 3] - self.estimates[-1].T_world_lidar[:3, 3]
        self.assertLess(np.linalg.norm(off), 0.2)

    def test_too_little_is_not_joined(self):
        mapper, odometry = Mapper(), Odometry()
        for i, scan in enumerate(self.walk):
            if i < 10:
                mapper.add(odometry.add_scan(scan), odometry.deskewed_scan()[0])
        mapper.finish()
        report = mapper.join(self.file)
        self.assertFalse(report.joined)
        self.assertTrue(report.message)
        self.assertEqual(len(mapper.trajectory()), 10)

    def test_what_is_wrong_is_said(self):
        with self.assertRaisesRegex(surefoot.ReadError, "nowhere.surefoot"):
            Localizer("nowhere.surefoot")
        with self.assertRaisesRegex(surefoot.ReadError, "nowhere"):
            self.mapper.join("nowhere")
        with self.assertRaisesRegex(surefoot.WriteError, "no_such_folder"):
            self.mapper.save(scratch("no_such_folder") / "map.surefoot")
        with self.assertRaisesRegex(RuntimeError, "finish"):
            self.mapper.finish()
        with self.assertRaisesRegex(RuntimeError, "finish"):
            Mapper().trajectory()
        with self.assertRaisesRegex(ValueError, r"\(N, 3\)"):
            Mapper().add(self.estimates[-1], np.zeros((4, 2), np.float32))


if __name__ == "__main__":
    unittest.main()
