# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""evalio's published interface as far as surefoot.evalio knows it: evalio is not here."""

import enum
import importlib
import os
import sys
import types
from pathlib import Path

import numpy as np


class Stamp:
    def __init__(self, nsec):
        self.nsec = nsec

    @classmethod
    def from_nsec(cls, nsec):
        return cls(nsec)

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
    def __init__(self, *, x=0, y=0, z=0, intensity=0, t=None, range=0, row=0, col=0):
        self.x, self.y, self.z, self.intensity, self.t = x, y, z, intensity, t or Stamp(0)
        self.range, self.row, self.col = range, row, col


class LidarMeasurement:
    def __init__(self, stamp, points):
        self.stamp, self.points = stamp, points

    def to_vec_positions(self):
        return np.array([(point.x, point.y, point.z) for point in self.points])


class Trajectory:
    def __init__(self, *, stamps, poses):
        self.stamps, self.poses = stamps, poses


class Params(types.SimpleNamespace):
    """LidarParams, ImuParams: what they are given."""


class Dataset(str, enum.Enum):
    """Sequences are strings; where their folders are comes from evalio's root."""

    @property
    def folder(self):
        return Path(os.environ["EVALIO_DATA"]) / f"{self.dataset_name()}/{self.value}"


class SavingPipeline:
    def __init__(self):
        self.saved = []

    def save(self, stamp, value):
        self.saved.append((stamp.to_nsec(), value))


class AskedPipeline:
    pass


def module_over(base, rotation):
    """surefoot.evalio with this for Pipeline, and this for SO3."""
    names = ("evalio", "evalio.datasets", "evalio.pipelines", "evalio.types")
    modules = {name: types.ModuleType(name) for name in names}
    modules["evalio.pipelines"].Pipeline = base
    modules["evalio.datasets"].Dataset = Dataset
    modules["evalio.datasets"].DatasetIterator = object
    for name, kind in {
        "SE3": SE3, "SO3": rotation, "Point": Point, "Stamp": Stamp, "Duration": Stamp,
        "LidarMeasurement": LidarMeasurement, "LidarParams": Params, "ImuParams": Params,
        "Trajectory": Trajectory,
    }.items():  # fmt: skip
        setattr(modules["evalio.types"], name, kind)
    sys.modules.update(modules)
    for name in ("surefoot.evalio", "surefoot.evalio_datasets"):
        sys.modules.pop(name, None)
    return importlib.import_module("surefoot.evalio")
