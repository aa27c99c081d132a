#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""Points from wherever you have them: arrays are looked at where they lie."""
import numpy as np

import surefoot


def measure(x: float, stamp_ns: int) -> surefoot.Scan:
    """A sensor at `x` in a room of 8 x 6 x 3 m, as numpy sees it."""
    azimuth = np.repeat(np.arange(0, 2 * np.pi, np.radians(0.4)), 16)
    elevation = np.tile(np.radians(np.arange(-15, 16, 2)), len(azimuth) // 16)
    ray = np.stack(
        [np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)],
        axis=1,
    )
    origin = np.array([x, 0.5, 0.2])
    walls = np.where(ray > 0, np.array([4.0, 3.0, 2.0]), np.array([-4.0, -3.0, -1.0]))
    with np.errstate(divide="ignore"):
        ranges = np.where(ray == 0, np.inf, (walls - origin) / ray)
    points = ray * np.min(ranges, axis=1, keepdims=True)
    cloud = np.zeros(len(points), [("x", "f4"), ("y", "f4"), ("z", "f4"), ("t", "i4")])
    for i, axis in enumerate("xyz"):
        cloud[axis] = points[:, i]
    cloud["t"] = np.linspace(0, 99_000_000, len(points))
    return surefoot.Scan.from_cloud(cloud, stamp_ns, time_unit="ns")


def main() -> None:
    odometry = surefoot.Odometry(surefoot.Config("surefoot", {"level.mode": "none"}))
    for i in range(10):
        estimate = odometry.add_scan(measure(0.02 * i, 100_000_000 * i))
    moved = estimate.T_world_lidar[0, 3]
    print(f"moved {moved:.3f} m of 0.180")
    assert estimate.trusted and abs(moved - 0.18) < 0.02, estimate


if __name__ == "__main__":
    main()
