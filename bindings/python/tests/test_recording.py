# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
import re
import shutil
import unittest
import warnings

import numpy as np
from support import SHARED_DATA, needs_program, needs_simulation, program, scratch, walk

import surefoot
from surefoot import ReadError


@needs_simulation
class RecordingTest(unittest.TestCase):
    def test_formats_hold_the_same_scans(self):
        simulation, folder = walk()
        pcd = list(surefoot.open(folder, format="pcd"))
        mcap = list(surefoot.open(folder / "recording.mcap"))
        self.assertEqual(len(pcd), 12)
        self.assertEqual(len(mcap), 12)
        for a, b, made in zip(pcd, mcap, simulation):
            np.testing.assert_array_equal(a.points, b.points)
            np.testing.assert_array_equal(a.points, made.points)
            np.testing.assert_array_equal(a.times_ns, made.times_ns)
            self.assertEqual(a.stamp_ns, made.stamp_ns)
        self.assertEqual(pcd[3].name, "000003.pcd")

    def test_a_capture_tells_its_packets(self):
        _, folder = walk()
        recording = surefoot.open(folder / "recording.pcap", sensor="VLP-16")
        scans = list(recording)
        self.assertGreater(len(scans), 10)
        self.assertEqual(recording.capture_counts["lost"], 0)
        self.assertGreater(recording.capture_counts["data_packets"], 800)
        self.assertIn("VLP-16", recording.description)
        self.assertEqual(recording.progress, 1.0)
        self.assertTrue(any("return mode" in note for note in recording.notes))

    def test_a_broken_scan_is_left_out_with_a_warning(self):
        _, folder = walk()
        broken = scratch("broken")
        shutil.copytree(folder, broken, ignore=shutil.ignore_patterns("*.pcap", "*.mcap"))
        (broken / "000004.pcd").write_bytes(b"no pcd")
        recording = surefoot.open(broken)
        with self.assertWarnsRegex(UserWarning, "left out: .*000004.pcd"):
            scans = list(recording)
        self.assertEqual(len(scans), 11)
        self.assertEqual(len(recording.left_out), 1)

    def test_scans_can_be_passed_over(self):
        _, folder = walk()
        recording = surefoot.open(folder)
        recording.skip(5)
        self.assertEqual(next(recording).name, "000005.pcd")

    def test_errors_name_the_file(self):
        with self.assertRaisesRegex(ReadError, "no-such.pcap: no such file or folder"):
            surefoot.open("no-such.pcap")
        _, folder = walk()
        with self.assertRaisesRegex(ValueError, "spin: got 'left', expected one of: clockwise"):
            surefoot.open(folder, spin="left")
        with self.assertRaisesRegex(TypeError, "no option 'colour'; it has: keep_partial, dataset, topic"):
            surefoot.open(folder, colour="red")
        with self.assertRaisesRegex(TypeError, "udp_port: got 'x'"):
            surefoot.open(folder, udp_port="x")

    def test_numbers_are_checked_and_none_is_not_given(self):
        _, folder = walk()
        nan, inf = float("nan"), float("inf")
        for name, values in {"rate": (nan, inf, 0, -5, 1e-300), "cut": (nan, inf, -1, 360),
                             "udp_port": (0, -1, 65536)}.items():
            for value in values:
                with self.assertRaisesRegex(ValueError, name + ": got .*, expected .* \\.\\. "):
                    surefoot.open(folder, **{name: value})
        self.assertEqual(len(list(surefoot.open(folder / "recording.mcap", topic=None))), 12)

    def test_a_warning_that_is_an_error_costs_only_what_it_tells_of(self):
        options = {"sensor": "VLP-16", "cut": 90}
        capture = walk()[1] / "recording.pcap"
        with self.assertWarnsRegex(UserWarning, "left out: revolution 0: partial"):
            expected = [scan.name for scan in surefoot.open(capture, **options)]
        recording = surefoot.open(capture, **options)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with self.assertRaisesRegex(UserWarning, "left out: revolution 0: partial"):
                next(recording)
        self.assertEqual([scan.name for scan in recording], expected)

    def test_a_truth_is_found_as_by_eval(self):
        _, folder = walk()
        truth, expected = surefoot.read_truth(folder), surefoot.read_tum(folder / "gt.tum")
        np.testing.assert_array_equal(truth.trajectory.stamps_ns, expected.stamps_ns)
        np.testing.assert_allclose(truth.trajectory.poses, expected.poses, atol=1e-12)

    @needs_program
    def test_the_options_are_the_programs(self):
        reading = program("run", "--help").split("\nReading:")[1].split("\n\n")[0]
        names = set(re.findall(r"^  --([a-z-]+)", reading, re.MULTILINE))
        self.assertGreater(len(names), 15)
        mine = {name.replace("_", "-") for name in surefoot._core._reading_options}
        self.assertEqual({"return" if name == "returns" else name for name in mine}, names)


class SharedRecordingTest(unittest.TestCase):
    """Real sensors' packets, where the recordings are here."""

    def test_a_partial_revolution_is_left_out_as_by_the_program(self):
        capture = SHARED_DATA / "vlp16_pcap" / "sample_velodyne_vlp16_gps.pcap"
        if not capture.exists():
            self.skipTest("no recordings here")
        with self.assertWarnsRegex(UserWarning, "left out: revolution 0: partial"):
            scans = list(surefoot.open(capture))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            every = list(surefoot.open(capture, keep_partial=True))
        self.assertEqual(len(every), len(scans) + 1)
        self.assertIn("partial", every[0].remark)


if __name__ == "__main__":
    unittest.main()
