# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""Recordings of legged robots as data sets of evalio (https://github.com/contagon/evalio):

    export EVALIO_DATA=~/data EVALIO_CUSTOM=surefoot.evalio
    evalio run -d "leg_kilo/*" -p surefoot

A sequence is a folder of that name, $EVALIO_DATA/leg_kilo/corridor, with its recording, as it was
downloaded, and its truth (gt.tum, or one .tum, .txt or .csv). Those that are there when evalio starts
are its sequences: evalio's -D comes too late, and nothing is downloaded. What is special about a data
set (which instant its stamps name, where its LiDAR sits) is what `surefoot datasets` says. Scans come
in evalio's way: stamped at their start, row by row, with empty points where nothing came back. The
LiDAR alone is read: pipelines that need an IMU cannot run on these.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Iterator, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from evalio.datasets import Dataset, DatasetIterator
from evalio.types import (
    SE3,
    SO3,
    Duration,
    ImuParams,
    LidarMeasurement,
    LidarParams,
    Point,
    Stamp,
    Trajectory,
)

import surefoot

_INFO = {info.name: info for info in surefoot.datasets()}
_MAKERS = ("Velodyne", "Hesai", "Ouster", "Livox")
_TRUTHS = ("gt.tum", "*.tum", "*gt*.txt", "*gt*.csv", "*.txt", "*.csv")
_RECORDINGS = ("*.bag", "*.mcap", "*.db3", "*.pcap", "*.pcapng")


def _pose(matrix: Optional[NDArray[np.float64]]) -> Any:
    """An evalio SE3 of 4x4; None: the identity."""
    if matrix is None:
        matrix = np.eye(4)
    make = SO3.from_mat if hasattr(SO3, "from_mat") else SO3.fromMat
    return SE3(make(np.ascontiguousarray(matrix[:3, :3])), np.ascontiguousarray(matrix[:3, 3]))


def _shape(scan: surefoot.Scan) -> tuple[int, int]:
    """Rows and columns of the scan's full grid; a row and as many columns as points where it has no rings."""
    if len(scan.rings) == 0 or len(scan.times_ns) == 0:
        return 1, max(len(scan), 1)
    rings = np.asarray(scan.rings)
    return int(rings.max()) + 1, int(np.bincount(rings).max())


def measurement(scan: surefoot.Scan, rows: int, columns: int) -> Any:
    """The scan as evalio has it: rows times columns points, in the columns that their times tell."""
    times = np.asarray(scan.times_ns, dtype=np.int64)
    if len(times) == 0:
        times = np.zeros(len(scan), dtype=np.int64)
    first = min(int(times.min()), 0) if len(times) else 0
    times = times - first  # evalio's stamp is the start, whatever ours is
    rings = np.asarray(scan.rings, dtype=np.int64)
    if len(rings) == 0:
        rings = np.zeros(len(scan), dtype=np.int64)
    grid: list[Any] = [None] * (rows * columns)
    order = np.lexsort((times, rings))
    ends = np.searchsorted(rings[order], np.arange(rows + 1))
    intensities = np.asarray(scan.intensities)
    if len(intensities) == 0:
        intensities = np.zeros(len(scan), dtype=np.float32)
    ranges = np.linalg.norm(scan.points, axis=1)
    last = max(int(times.max()), 1) if len(times) else 1
    for row in range(rows):
        column = -1
        mine = order[ends[row] : ends[row + 1]][:columns]
        for place, i in enumerate(mine):
            wanted = int(times[i] * (columns - 1) // last)
            column = min(max(wanted, column + 1), columns - len(mine) + place)
            x, y, z = (float(value) for value in scan.points[i])
            grid[row * columns + column] = Point(
                x=x, y=y, z=z, intensity=float(intensities[i]), t=Duration.from_nsec(int(times[i])),
                range=int(ranges[i] * 1000), row=row, col=column,
            )  # fmt: skip
    for place, point in enumerate(grid):
        if point is None:
            grid[place] = Point(row=place // columns, col=place % columns)
    return LidarMeasurement(Stamp.from_nsec(scan.stamp_ns + first), grid)


class _Scans(DatasetIterator):
    """Of one sequence. The LiDAR alone."""

    def __init__(self, sequence: Any) -> None:
        self._sequence = sequence

    def imu_iter(self) -> Iterator[Any]:
        return iter(())

    def lidar_iter(self) -> Iterator[Any]:
        rows, columns = self._sequence.shape()
        for scan in self._sequence.open():
            yield measurement(scan, rows, columns)

    def __iter__(self) -> Iterator[Any]:
        return self.lidar_iter()

    def __len__(self) -> int:
        recording = self._sequence.open()
        size: Optional[int] = recording.size
        return sum(1 for _ in recording) if size is None else size


def _found(name: str) -> list[str]:
    """Sequences that are there."""
    folder = Path(os.environ.get("EVALIO_DATA", "evalio_data")) / name
    return sorted(one.name for one in folder.iterdir() if one.is_dir()) if folder.is_dir() else []


def _dataset(class_name: str, name: str, preset: str, vehicle: str, bag: str = "") -> Any:
    """The data set as evalio's kind of enumeration: `preset` is one of surefoot.datasets(), or empty.

    bag: what the bag with its scans is called, where there are others beside it.
    """
    info = _INFO.get(preset)

    class Legged(Dataset):  # without members, so that it can have some further down
        def open(self) -> surefoot.Recording:
            """The sequence's scans, as surefoot.open gives them."""
            return surefoot.open(self._recording(), dataset=preset) if preset else surefoot.open(self._recording())

        def _recording(self) -> Path:
            """The one recording that is there, or else the folder: of scans, or of a bag's parts."""
            folder = Path(self.folder)
            for pattern in (bag, *_RECORDINGS):
                found = sorted(folder.glob(pattern)) if pattern else []
                if found:
                    return found[0] if len(found) == 1 else folder
            return folder

        def _truth(self) -> Path:
            for pattern in _TRUTHS:
                found = sorted(one for one in Path(self.folder).glob(pattern) if one.name != "times.txt")
                if found:
                    return found[0]
            raise ValueError(f"{self.folder}: no truth in it, expected gt.tum, or a .txt or .csv")

        def shape(self) -> tuple[int, int]:
            """Rows and columns that any of the first scans has."""
            shapes = [_shape(scan) for scan, _ in zip(self.open(), range(5))]
            return max(rows for rows, _ in shapes), max(columns for _, columns in shapes)

        def data_iter(self) -> Any:
            return _Scans(self)

        def ground_truth_raw(self) -> Any:
            truth = surefoot.read_truth(self._truth(), preset)
            if not truth.has_stamps or not truth.has_rotations:
                raise ValueError(
                    f"{self._truth()}: {truth.what}, evalio needs stamped poses with rotations; "
                    "`surefoot eval` takes it"
                )
            poses = truth.trajectory
            return Trajectory(
                stamps=[Stamp.from_nsec(int(stamp)) for stamp in poses.stamps_ns],
                poses=[_pose(pose) for pose in poses.poses],
            )

        def imu_T_lidar(self) -> Any:
            """What `surefoot datasets` calls T_base_lidar: the base is the IMU where it is known."""
            return _pose(info.T_base_lidar if info else None)

        def imu_T_gt(self) -> Any:
            base = info.T_base_lidar if info else None
            told = info.T_lidar_truth if info else None
            whole = np.eye(4) if base is None else base
            return _pose(whole if told is None else whole @ told)

        def imu_params(self) -> Any:
            """Of no IMU: none is read."""
            return ImuParams(
                gyro=0.0, accel=0.0, gyro_bias=0.0, accel_bias=0.0, bias_init=0.0, integration=0.0,
                gravity=np.array([0.0, 0.0, -9.81]),
            )  # fmt: skip

        def lidar_params(self) -> Any:
            """Its rows and columns as its first scans have them; any range."""
            rows, columns = self.shape()
            what = info.what if info else ""
            brand = next((maker for maker in _MAKERS if maker in what), "-")
            return LidarParams(
                num_rows=rows, num_columns=columns, min_range=0.1, max_range=200.0, brand=brand, model=what or "-"
            )

        def files(self) -> Sequence[Union[str, Path]]:
            return [self.folder]

        @classmethod
        def dataset_name(cls) -> str:
            return name

        def vehicle(self) -> str:
            return vehicle

    return Legged(class_name, {sequence: sequence for sequence in _found(name)}, module=__name__)


LegKilo: Any = _dataset("LegKilo", "leg_kilo", "leg-kilo", "Unitree Go1")
# Of its bags, one for each topic, that of the Hesai.
GrandTour: Any = _dataset("GrandTour", "grand_tour", "grandtour", "ANYmal", bag="*hesai*.bag")
DiTer: Any = _dataset("DiTer", "diter", "diter", "Unitree Go2, Spot")
FusionPortableLegged: Any = _dataset(
    "FusionPortableLegged", "fusion_portable_legged", "fusionportable-legged", "Unitree A1"
)
QuadrupedSlam: Any = _dataset("QuadrupedSlam", "quadruped_slam", "quadruped-slam", "Unitree Go2")
# Anybody's: whatever `surefoot run` reads, with a truth of the LiDAR.
LeggedRecordings: Any = _dataset("LeggedRecordings", "legged_recordings", "", "legged robot")
