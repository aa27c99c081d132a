# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
import unittest

import numpy as np
from support import needs_simulation, walk

from surefoot import Odometry, ReadError, Scan, Status


def cloud_of(scan, time_type="<i4", scale=1):
    """The scan as a message's cloud: padding between the fields, as drivers have it."""
    layout = np.dtype(
        {
            "names": ["x", "y", "z", "intensity", "time", "ring"],
            "formats": ["<f4", "<f4", "<f4", "<f4", time_type, "<u2"],
            "offsets": [0, 4, 8, 16, 20, 28],
            "itemsize": 32,
        }
    )
    cloud = np.zeros(len(scan), layout)
    cloud["x"], cloud["y"], cloud["z"] = scan.points.T
    cloud["intensity"], cloud["ring"] = scan.intensities, scan.rings
    cloud["time"] = scan.times_ns * scale
    return cloud


class ScanTest(unittest.TestCase):
    def setUp(self):
        random = np.random.default_rng(1)
        self.points = random.uniform(-20, 20, (500, 3)).astype(np.float32)
        self.times_ns = np.arange(500, dtype=np.int32) * 200_000

    def test_arrays_of_the_right_type_are_not_copied(self):
        for points in (self.points, self.points[::2], np.hstack([self.points] * 2)[:, :3]):
            scan = Scan(points, times_ns=self.times_ns[: len(points)])
            self.assertTrue(np.shares_memory(scan.points, points))
            self.assertTrue(np.shares_memory(scan.times_ns, self.times_ns))
            self.assertEqual(len(scan), len(points))

    def test_others_are_converted(self):
        scan = Scan(
            self.points.astype(np.float64),
            times=self.times_ns * 1e-9,
            rings=list(range(500)),
            intensities=np.arange(500),
        )
        np.testing.assert_array_equal(scan.points, self.points)
        np.testing.assert_array_equal(scan.times_ns, self.times_ns)
        self.assertEqual(scan.rings.dtype, np.uint16)
        self.assertEqual(scan.intensities.dtype, np.float32)
        np.testing.assert_array_equal(Scan(np.asfortranarray(self.points)).points, self.points)

    def test_wrong_shapes_say_what_was_expected(self):
        for what, arguments in {
            r"points: got an array \(500, 2\) float32, expected \(N, 3\)": (self.points[:, :2], {}),
            r"times_ns: got an array \(499,\) int32, expected \(500,\)": (
                self.points,
                {"times_ns": self.times_ns[1:]},
            ),
            r"times: got 3.0.* s, expected seconds": (self.points, {"times": np.full(500, 3.0)}),
            r"times: got nan": (self.points, {"times": np.full(500, np.nan)}),
            "got both": (self.points, {"times": self.times_ns, "times_ns": self.times_ns}),
            "structured array, expected": (np.zeros(3, [("x", "f4")]), {}),
        }.items():
            with self.assertRaisesRegex(ValueError, "scan of stamp 17 ns: .*" + what):
                Scan(arguments[0], stamp_ns=17, **arguments[1])
        with self.assertRaisesRegex(ValueError, "points: got 'points', expected numbers"):
            Scan("points")

    def test_what_does_not_fit_says_so(self):
        epoch = 1_700_000_000_000_000_000
        absolute = self.times_ns.astype(np.int64) + epoch
        for what, arguments in {
            f"times_ns: got {epoch} to .*, expected -2147483648 to": {"times_ns": absolute},
            "times_ns: got nan to nan": {"times_ns": np.full(500, np.nan)},
            "rings: got -1 to 498, expected 0 to 65535": {"rings": np.arange(-1, 499)},
            "rings: got 65536 to 65536": {"rings": [65536] * 500},
            r"times_ns: got 0\.0002.*, expected whole numbers": {"times_ns": self.times_ns * 1e-9},
            "times_ns: got an array .*timedelta64.*, expected numbers": {
                "times_ns": self.times_ns.astype("m8[ns]")
            },
            "rings: got an array .*complex128, expected numbers": {"rings": np.zeros(500, complex)},
            "times_ns: got 0 to 1099511627776, expected": {
                "times_ns": np.array([0] * 499 + [2**40], dtype=object)
            },
            "times_ns: got an array .*object, expected numbers": {"times_ns": [0] * 499 + [2**70]},
            "intensities: got an array .*object, expected numbers": {"intensities": [None] * 500},
        }.items():
            with self.assertRaisesRegex(ValueError, what):
                Scan(self.points, **arguments)
        for kind in (np.int64, np.float64, np.dtype(">i4"), object):
            scan = Scan(self.points, times_ns=self.times_ns.astype(kind))
            np.testing.assert_array_equal(scan.times_ns, self.times_ns)
        np.testing.assert_array_equal(Scan(self.points.astype(object)).points, self.points)
        self.assertEqual(len(Scan(np.zeros((0, 3)), times_ns=[], rings=[]).rings), 0)

    def test_a_useless_scan_is_rejected_not_raised(self):
        for points in (np.zeros((0, 3)), np.zeros((500, 3)), np.full((500, 3), np.nan)):
            estimate = Odometry().add_scan(Scan(points))
            self.assertEqual(estimate.status, Status.rejected)
            self.assertIn("expected", estimate.message)
            self.assertFalse(estimate.trusted)


@needs_simulation
class CloudTest(unittest.TestCase):
    def setUp(self):
        self.scan = walk()[0][0]

    def assert_same(self, scan):
        for name in ("points", "times_ns", "intensities", "rings"):
            np.testing.assert_array_equal(getattr(scan, name), getattr(self.scan, name), name)
        self.assertEqual(scan.stamp_ns, self.scan.stamp_ns)

    def test_a_cloud_in_nanoseconds_is_looked_into(self):
        cloud = cloud_of(self.scan)
        scan = Scan.from_cloud(cloud, self.scan.stamp_ns)
        self.assert_same(scan)
        for name in ("points", "times_ns", "intensities", "rings"):
            self.assertTrue(np.shares_memory(getattr(scan, name), cloud), name)
        every_other = Scan.from_cloud(cloud[::2], self.scan.stamp_ns)
        np.testing.assert_array_equal(every_other.points, self.scan.points[::2])

    def test_what_the_program_reads_otherwise_is_not_looked_into(self):
        cloud = cloud_of(self.scan)
        wide = cloud.astype([(name, "<i4" if name == "ring" else kind)
                             for name, kind in cloud.dtype.descr if name])
        wide["ring"][0] = -1
        scan = Scan.from_cloud(wide, self.scan.stamp_ns)
        self.assertEqual(scan.rings[0], 0)
        cloud["time"][0] = 2_000_000_000  # a stray one, whose point goes
        self.assertEqual(len(Scan.from_cloud(cloud, self.scan.stamp_ns)), len(self.scan) - 1)

    def test_seconds_are_found_out(self):
        self.assert_same(Scan.from_cloud(cloud_of(self.scan, "<f8", 1e-9), self.scan.stamp_ns))

    def test_other_byte_orders_and_epochs_too(self):
        cloud = cloud_of(self.scan)
        swapped = cloud.astype(cloud.dtype.newbyteorder(">"))
        self.assert_same(Scan.from_cloud(swapped, self.scan.stamp_ns))
        absolute = cloud_of(self.scan, "<f8")
        absolute["time"] = (self.scan.stamp_ns + self.scan.times_ns.astype(np.int64)) * 1e-9
        scan = Scan.from_cloud(absolute, self.scan.stamp_ns, time_reference="absolute")
        self.assertLess(np.abs(scan.times_ns - self.scan.times_ns).max(), 1000)

    def test_same_answer_whatever_the_layout(self):
        fields = dict(times_ns=self.scan.times_ns, rings=self.scan.rings)
        scans = [
            self.scan,
            Scan.from_cloud(cloud_of(self.scan), self.scan.stamp_ns),
            Scan(np.hstack([self.scan.points] * 2)[:, 3:], stamp_ns=self.scan.stamp_ns, **fields),
        ]
        maps = []
        for scan in scans:
            odometry = Odometry()
            odometry.add_scan(scan)
            maps.append(odometry.local_map())
        for one in maps[1:]:
            np.testing.assert_array_equal(one, maps[0])

    def test_what_is_missing_is_named(self):
        with self.assertRaisesRegex(ReadError, "'?z'?"):
            Scan.from_cloud(np.zeros(5, [("x", "f4"), ("y", "f4")]))
        with self.assertRaisesRegex(ValueError, "expected a structured one"):
            Scan.from_cloud(np.zeros((5, 3)))
        with self.assertRaisesRegex(ValueError, "time_unit: got 'h', expected one of: auto, s"):
            Scan.from_cloud(cloud_of(self.scan), time_unit="h")


if __name__ == "__main__":
    unittest.main()
