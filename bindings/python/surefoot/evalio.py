# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""Surefoot as a pipeline of evalio (https://github.com/contagon/evalio), and legged data sets for it:

    EVALIO_CUSTOM=surefoot.evalio evalio run -d botanic_garden/1018_00 -p surefoot

Written for evalio 0.5, and what came before it; tests/test_evalio.py has a stand-in of either's
interface, since no package of evalio is at hand. Poses are saved at the stamp of each measurement,
which in evalio is the start of the scan; the LiDAR's alone are used, IMU measurements are passed over.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from evalio.pipelines import Pipeline
from evalio.types import SE3, SO3, Point

import surefoot

from .evalio_datasets import (  # evalio looks for them in the module that it is given
    DiTer as DiTer,
    FusionPortableLegged as FusionPortableLegged,
    GrandTour as GrandTour,
    LeggedRecordings as LeggedRecordings,
    LegKilo as LegKilo,
    QuadrupedSlam as QuadrupedSlam,
)


def _matrix(pose: Any) -> NDArray[np.float64]:
    """4x4 of an evalio SE3. Before 0.5 its methods had names in camelCase."""
    rotation = pose.rot.to_mat() if hasattr(pose.rot, "to_mat") else pose.rot.toMat()
    result = np.eye(4)
    result[:3, :3] = np.asarray(rotation)
    result[:3, 3] = np.asarray(pose.trans).ravel()
    return result


def _rotation(matrix: NDArray[np.float64]) -> Any:
    """An evalio SO3 of 3x3."""
    return SO3.from_mat(matrix) if hasattr(SO3, "from_mat") else SO3.fromMat(matrix)


class Surefoot(Pipeline):
    """Parameters are those of `surefoot config`, by the same names, and `threads`."""

    def __init__(self) -> None:
        super().__init__()
        self._config = surefoot.Config()
        self._threads = 1
        self._odometry: Any = None
        self._T_lidar_imu = np.eye(4)
        self._pose = np.eye(4)

    @staticmethod
    def name() -> str:
        return "surefoot"

    @staticmethod
    def version() -> str:
        return surefoot.__version__

    @staticmethod
    def url() -> str:
        return "url-not-set"

    @staticmethod
    def default_params() -> dict[str, Any]:
        return {"threads": 1, **dict(surefoot.Config().items())}

    def set_params(self, params: dict[str, Any]) -> dict[str, Any]:
        """Takes the parameters that it knows; gives the others back."""
        left = dict(params)
        self._threads = left.pop("threads", self._threads)
        for name in [name for name in left if name in self._config]:
            self._config[name] = left.pop(name)
        return left

    def set_imu_params(self, params: Any) -> None:
        pass

    def set_lidar_params(self, params: Any) -> None:
        """Ranges beyond the data set's are no measurements; a narrower setting stays."""
        nearest, farthest = "preprocess.min_range", "preprocess.max_range"
        self._config[nearest] = max(self._config[nearest], float(params.min_range))
        self._config[farthest] = min(self._config[farthest], float(params.max_range))

    def set_imu_T_lidar(self, T: Any) -> None:
        self._T_lidar_imu = np.linalg.inv(_matrix(T))

    def initialize(self) -> None:
        self._odometry = surefoot.Odometry(self._config, threads=self._threads)

    def add_imu(self, mm: Any) -> None:
        pass

    def add_lidar(self, mm: Any) -> list[Any]:
        stamp_ns = mm.stamp.to_nsec()
        scan = surefoot.Scan(
            np.asarray(mm.to_vec_positions(), dtype=np.float32),
            stamp_ns=stamp_ns,
            times_ns=np.array([point.t.to_nsec() for point in mm.points], dtype=np.int32),
            rings=np.array([point.row for point in mm.points], dtype=np.uint16),
        )
        estimate = self._odometry.add_scan(scan)
        self._pose = estimate.pose_at(stamp_ns) @ self._T_lidar_imu
        if hasattr(self, "save"):  # older versions of evalio ask pose() instead
            self.save(mm.stamp, self.pose())
        return []

    def pose(self) -> Any:
        return SE3(_rotation(self._pose[:3, :3]), self._pose[:3, 3])

    def map(self) -> Any:
        points = [Point(x=x, y=y, z=z) for x, y, z in self._odometry.local_map()]
        return {"map": points} if hasattr(self, "save") else points
