# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""LiDAR odometry for robots that walk: scans in, trajectory and map out, with the LiDAR alone.

>>> import surefoot
>>> odometry = surefoot.Odometry()
>>> for scan in surefoot.open("walk.mcap"):
...     estimate = odometry.add_scan(scan)

Names are those of the C++ library. Metres, radians and nanoseconds unless a name says otherwise;
T_a_b takes a point from frame b to frame a.
"""

from . import _core
from ._core import (
    Config,
    ConfigError,
    DatasetInfo,
    DegenerateDirection,
    Errors,
    Estimate,
    JoinReport,
    LevelReport,
    Localizer,
    Mapper,
    Odometry,
    ParameterInfo,
    ReadError,
    Recording,
    Scan,
    StageReport,
    Status,
    Trajectory,
    Truth,
    WriteError,
    ape,
    datasets,
    evaluate,
    method_config,
    methods,
    open,
    parameters,
    read_truth,
    read_tum,
    rpe,
    write_tum,
)
from ._core import __version__ as __version__
from ._run import Run, read_run, run

__all__ = [
    "Config",
    "ConfigError",
    "DatasetInfo",
    "DegenerateDirection",
    "Errors",
    "Estimate",
    "JoinReport",
    "LevelReport",
    "Localizer",
    "Mapper",
    "Odometry",
    "ParameterInfo",
    "ReadError",
    "Recording",
    "Run",
    "Scan",
    "StageReport",
    "Status",
    "Trajectory",
    "Truth",
    "WriteError",
    "ape",
    "datasets",
    "evaluate",
    "method_config",
    "methods",
    "open",
    "parameters",
    "read_run",
    "read_truth",
    "read_tum",
    "rpe",
    "run",
    "write_tum",
]

# Built without Embree there is no simulation.
if hasattr(_core, "simulate"):
    from ._core import Simulation, scenes, simulate

    __all__ += ["Simulation", "scenes", "simulate"]
