#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""Scan by scan: the pose of each, how sure it is, and the error against the truth.

    odometry.py [RECORDING]        without one, a simulated walk is made in memory
"""
import sys
from collections.abc import Iterable

import numpy as np

import surefoot


def main() -> None:
    scans: Iterable[surefoot.Scan]
    truth = None
    if len(sys.argv) > 1:
        scans = surefoot.open(sys.argv[1])
    else:
        walk = surefoot.simulate("corridor", scans=20, footprint=False)
        scans, truth = walk, walk.truth

    odometry = surefoot.Odometry(surefoot.Config("surefoot", {"knots.points": 1500}))
    path = surefoot.Trajectory()
    for scan in scans:
        estimate = odometry.add_scan(scan)
        if not estimate.trusted:
            print(f"{scan.name}: {estimate.status.name}: {estimate.message}")
            continue
        x, y, z = estimate.T_world_lidar[:3, 3]
        sigma = np.sqrt(np.diag(estimate.covariance))[:3]
        print(f"{scan.name}: {x:.3f} {y:.3f} {z:.3f} m, +- {1e3 * sigma.max():.1f} mm")
        path.add(estimate)

    print(odometry.level().message)
    print(f"{len(path)} poses, local map of {len(odometry.local_map())} points")
    if truth is not None:
        error = surefoot.ape(truth, path)
        print(f"APE {1e3 * error.rmse:.1f} mm")
        assert error.rmse < 0.02, error


if __name__ == "__main__":
    main()
